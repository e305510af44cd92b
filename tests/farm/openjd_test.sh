#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Open Job Description's own program checks the template and runs it. Usage: openjd_test.sh PROXIMA SOURCE_FOLDER VENV
set -eu
proxima=$1
source=$2
venv=$3
template=$source/examples/farm/openjd_template.yaml
if [ ! -x "$venv/bin/openjd" ]; then
    if ! { python3 -m venv "$venv" && "$venv/bin/pip" install -q --timeout 20 --retries 1 openjd-cli; } >/dev/null 2>&1; then
        rm -rf "$venv"
        echo "skipped: Open Job Description: openjd-cli cannot be installed from PyPI"
        exit 77
    fi
fi
openjd=$venv/bin/openjd
D=$(mktemp -d /tmp/proxima_openjd.XXXXXX)
trap 'rm -rf "$D"' EXIT
mkdir "$D/farm" "$D/plain"
scene=$source/examples/12_pendulum_wave.scn
"$openjd" check "$template"
"$openjd" run "$template" --step Render -p Program="$proxima" -p Scene="$scene" -p Frames=1-25 -p Size=64x48 \
    -p OutputDir="$D/farm" | tee "$D/log" | tail -n 5
grep -q 'openjd_progress: 100' "$D/log"
"$proxima" render "$scene" -o "$D/plain/frame.%04d.exr" --frames 1-25 --size 64x48 --progress none
diff -r "$D/farm" "$D/plain" && echo "25 frames are the same, byte by byte"
