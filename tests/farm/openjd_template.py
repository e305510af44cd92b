#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks an Open Job Description template, and runs its task as a farm would, for machines without openjd-cli.

openjd_template.py check TEMPLATE
openjd_template.py run TEMPLATE NAME=VALUE...   the chunks of frames one after the other

The schema beside this file says what a template may hold; the rules that a schema cannot say are below.
"""
import json
import pathlib
import re
import subprocess
import sys

import jsonschema
import yaml

REFERENCE = re.compile(r"\{\{\s*(.*?)\s*\}\}")


def texts(node):
    """Every text in a tree of lists and dictionaries."""
    if isinstance(node, str):
        yield node
    for child in node.values() if isinstance(node, dict) else node if isinstance(node, list) else []:
        yield from texts(child)


def check_names(definitions, what):
    names = [definition["name"] for definition in definitions]
    assert len(set(names)) == len(names), f"two {what} have the same name: {names}"
    return names


def check_references(node, known):
    for text in texts(node):
        for reference in REFERENCE.findall(text):
            assert reference in known, f"'{{{{{reference}}}}}' names nothing; there are {sorted(known)}"


def references(prefix, names):
    return {f"{prefix}{kind}.{name}" for kind in ("Param", "RawParam") for name in names}


def check(template):
    schema = json.loads(pathlib.Path(__file__).with_name("openjd_schema.json").read_text())
    jsonschema.validate(template, schema)
    definitions = template.get("parameterDefinitions", [])
    job = references("", check_names(definitions, "parameters"))
    check_names(template["steps"], "steps")
    # Paths are known on the host that runs a task, not where the job is made.
    early = job - {f"Param.{d['name']}" for d in definitions if d["type"] == "PATH"}
    check_references(template["name"], early)
    for step in template["steps"]:
        tasks = step.get("parameterSpace", {}).get("taskParameterDefinitions", [])
        names = check_names(tasks, "task parameters")
        assert not tasks or "TASK_CHUNKING" in template.get("extensions", []), "CHUNK[INT] needs TASK_CHUNKING"
        assert len(tasks) <= 1, "only one parameter may be in chunks"
        check_references(tasks, early)
        check_references(step["script"], job | references("Task.", names))


def run(template, values):
    for definition in template["parameterDefinitions"]:
        value = values.get(definition["name"], definition.get("default"))
        assert value is not None, f"{definition['name']} has no value"
        values[definition["name"]] = value
    known = {f"Param.{name}": value for name, value in values.items()}
    filled = lambda text: REFERENCE.sub(lambda found: known[found.group(1)], text)
    (step,) = template["steps"]
    (frames,) = step["parameterSpace"]["taskParameterDefinitions"]
    first, last = map(int, filled(frames["range"]).split("-"))
    size = frames["chunks"]["defaultTaskCount"]
    action = step["script"]["actions"]["onRun"]
    for begin in range(first, last + 1, size):
        known[f"Task.Param.{frames['name']}"] = f"{begin}-{min(begin + size - 1, last)}"
        subprocess.run([filled(action["command"])] + [filled(text) for text in action["args"]], check=True)


if __name__ == "__main__":
    command, path, *settings = sys.argv[1:]
    loaded = yaml.safe_load(pathlib.Path(path).read_text())
    try:
        check(loaded)
    except (AssertionError, jsonschema.ValidationError) as error:
        sys.exit(f"{path}: {getattr(error, 'message', error)}")
    if command == "run":
        run(loaded, dict(setting.split("=", 1) for setting in settings))
