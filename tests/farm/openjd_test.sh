#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# The Open Job Description template is checked against its schema, and renders a short animation: by openjd-cli where
# that can be installed, else by what stands in for it. Usage: openjd_test.sh PROXIMA SOURCE_FOLDER VENV
set -eu
proxima=$1
source=$2
venv=$3
here=$(cd "$(dirname "$0")" && pwd)
template=$source/examples/farm/openjd_template.yaml
python=
for candidate in python3 /usr/bin/python3; do
    if "$candidate" -c 'import jsonschema, yaml' 2>/dev/null; then
        python=$candidate
        break
    fi
done
if [ -z "$python" ]; then
    echo "skipped: Open Job Description: apt-get install python3-jsonschema python3-yaml"
    exit 77
fi
if [ ! -x "$venv/bin/openjd" ]; then
    if ! { python3 -m venv "$venv" && "$venv/bin/pip" install -q --timeout 20 --retries 1 openjd-cli; } >/dev/null 2>&1; then
        rm -rf "$venv"
    fi
fi
openjd=$venv/bin/openjd
D=$(mktemp -d /tmp/proxima_openjd.XXXXXX)
trap 'rm -rf "$D"' EXIT
mkdir "$D/farm" "$D/plain"
scene=$source/examples/12_pendulum_wave.scn

"$python" "$here/openjd_template.py" check "$template"
wrong=0
while read -r change; do # what the check must notice
    sed "$change" "$template" >"$D/wrong.yaml"
    cmp -s "$template" "$D/wrong.yaml" && { echo "$change changes nothing"; exit 1; }
    if "$python" "$here/openjd_template.py" check "$D/wrong.yaml" 2>/dev/null; then
        echo "not noticed: $change"
        exit 1
    fi
    if [ -x "$openjd" ] && "$openjd" check "$D/wrong.yaml" >/dev/null 2>&1; then
        echo "openjd-cli takes it: $change"
        exit 1
    fi
    wrong=$((wrong + 1))
done <<'END'
s/jobtemplate-2023-09/jobtemplate-2023-10/
/^extensions/d
s/TASK_CHUNKING/TASK_CHUNKS/
/^name:/d
s/name: Size/name: Frames/
s/type: PATH, objectType: FILE/type: STRING, objectType: FILE/
s/objectType: DIRECTORY/objectType: FOLDER/
s/{{Param.Size}}/{{Param.Sise}}/
s/{{Task.Param.Frame}}/{{Task.Param.Frames}}/
s/range: "{{Param.Frames}}"/range: "{{Param.Scene}}"/
s/CHUNK\[INT\]/CHUNK[FLOAT]/
s/defaultTaskCount: 10/defaultTaskCount: 0/
s/rangeConstraint: NONCONTIGUOUS/rangeConstraint: ANY/
s/, rangeConstraint: NONCONTIGUOUS//
s/onRun:/onrun:/
s/command: .*/comand: proxima/
s/notifyPeriodInSeconds: 30/notifyPeriodInSeconds: 601/
s/cancelation:/cancellation:/
END
echo "the template is right, and $wrong wrong ones are noticed"

if [ -x "$openjd" ]; then
    "$openjd" check "$template"
    "$openjd" run "$template" --step Render -p Program="$proxima" -p Scene="$scene" -p Frames=1-25 -p Size=64x48 \
        -p OutputDir="$D/farm" | tee "$D/log" | tail -n 5
    grep -q 'openjd_progress: 100' "$D/log"
else
    echo "openjd-cli cannot be installed from PyPI: its tasks are run without it"
    "$python" "$here/openjd_template.py" run "$template" Program="$proxima" Scene="$scene" Frames=1-25 Size=64x48 \
        OutputDir="$D/farm" 2>&1 | tee "$D/log" | grep -c 'openjd_progress: 100' | xargs test 3 -eq
fi
"$proxima" render "$scene" -o "$D/plain/frame.%04d.exr" --frames 1-25 --size 64x48 --progress none
diff -r "$D/farm" "$D/plain" && echo "25 frames are the same, byte by byte"
