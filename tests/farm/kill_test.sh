#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Kills runs at random moments and goes on with --skip-existing: a final name never holds a part of a frame, and in the
# end all frames are those of an undisturbed run, and nothing else is left. Usage: kill_test.sh PROXIMA SOURCE_FOLDER COUNT
set -eu
proxima=$1
scene=$2/examples/12_pendulum_wave.scn
count=$3
D=$(mktemp -d /tmp/proxima_kill.XXXXXX)
trap 'rm -rf "$D"' EXIT
mkdir "$D/killed" "$D/plain"
run_to() { # FOLDER: fills `run` with the command that renders into it
    run=("$proxima" render "$scene" -o "$D/$1/f.##.$ending" --frames 1-12 --cyclic --size 320x240 --device cpu
        --progress none)
}
RANDOM=7
endings=(exr png tif jpg)
kills=0 finished=0 rounds=0 leftovers=0
while [ $kills -lt "$count" ]; do
    ending=${endings[rounds % 4]}
    rm -rf "$D"/killed/* "$D"/plain/*
    start=$(date +%s%N)
    run_to plain
    "${run[@]}"
    milliseconds=$((($(date +%s%N) - start) / 1000000 + 1))
    run_to killed
    for _ in 1 2 3 4 5 6; do
        "${run[@]}" --skip-existing & # no function in between: $! is the renderer's, not a shell's around it
        pid=$!
        sleep "$(printf '0.%03d' $((RANDOM % milliseconds % 1000)))"
        kill -KILL $pid 2>/dev/null || true
        status=0
        wait $pid 2>/dev/null || status=$?
        case $status in
        137) kills=$((kills + 1)) ;;
        0) finished=$((finished + 1)) ;;
        *) echo "a run ended with $status" && exit 1 ;;
        esac
        leftovers=$((leftovers + $(find "$D/killed" -name '.*.tmp' | wc -l)))
        for file in "$D"/killed/f.*; do
            [ -e "$file" ] || continue
            cmp "$file" "$D/plain/${file##*/}"
        done
    done
    echo "a part" >"$D/killed/.f.07.$ending.$(head -c 8 /proc/sys/kernel/random/boot_id)01234567.tmp"
    "${run[@]}" --skip-existing
    (cd "$D" && diff -r killed plain)
    rounds=$((rounds + 1))
done
echo "$kills runs were killed and $finished were too quick, in $rounds rounds: no part of a frame, the same bytes"
echo "$leftovers unfinished files were found after runs, and none at the end"
