#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Kills runs at random moments and goes on with --skip-existing: a final name never holds a part of a frame, and in the
# end all frames are those of an undisturbed run. Usage: kill_test.sh PROXIMA SOURCE_FOLDER COUNT
set -eu
proxima=$1
scene=$2/examples/12_pendulum_wave.scn
count=$3
D=$(mktemp -d /tmp/proxima_kill.XXXXXX)
trap 'rm -rf "$D"' EXIT
mkdir "$D/killed" "$D/plain"
render() ( # FOLDER [OPTION...]; a process of its own, which becomes the renderer: that is who is killed
    local folder=$1
    shift
    exec "$proxima" render "$scene" -o "$D/$folder/f.##.$ending" --frames 1-12 --cyclic --size 320x240 --device cpu \
        --progress none "$@"
)
RANDOM=7
endings=(exr png tif jpg)
kills=0 finished=0 rounds=0
while [ $kills -lt "$count" ]; do
    ending=${endings[rounds % 4]}
    rm -rf "$D"/killed/* "$D"/killed/.*.tmp "$D"/plain/*
    start=$(date +%s%N)
    render plain
    milliseconds=$((($(date +%s%N) - start) / 1000000 + 1))
    for _ in 1 2 3 4 5 6; do
        render killed --skip-existing &
        pid=$!
        sleep "$(printf '0.%03d' $((RANDOM % milliseconds % 1000)))"
        if kill -KILL $pid 2>/dev/null; then kills=$((kills + 1)); else finished=$((finished + 1)); fi
        wait $pid 2>/dev/null || true
        for file in "$D"/killed/f.*; do
            [ -e "$file" ] || continue
            cmp "$file" "$D/plain/${file##*/}"
        done
    done
    render killed --skip-existing
    (cd "$D" && diff -r --exclude='.*.tmp' killed plain)
    rounds=$((rounds + 1))
done
echo "$kills runs were killed and $finished were too quick, in $rounds rounds: no part of a frame, the same bytes"
