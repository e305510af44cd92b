#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A disk that is full, a folder that may not be written, one that vanishes: an error that names the file, no part of a
# file, and no old file lost. Needs a file system of its own. Usage: disk_test.sh PROXIMA SOURCE_FOLDER
set -eu
if [ "${3:-}" != inside ]; then
    if ! unshare -rm true 2>/dev/null; then
        echo "skipped: disks: this machine lets nobody make a file system (unshare -rm)"
        exit 77
    fi
    exec unshare -rm "$0" "$1" "$2" inside
fi
proxima=$1
scene=$2/examples/12_pendulum_wave.scn
D=$(mktemp -d /tmp/proxima_disk.XXXXXX)
trap 'umount "$D" 2>/dev/null; rm -rf "$D"' EXIT
mount -t tmpfs -o size=64k none "$D"

fails() { # MESSAGE OPTION...
    local message=$1 code=0
    shift
    "$proxima" render "$scene" --device cpu --progress none "$@" 2>"$D/../disk.$$" || code=$?
    grep -q "$message" "$D/../disk.$$" && [ $code -eq 3 ] ||
        { echo "exit code $code for $*:"; cat "$D/../disk.$$"; rm -f "$D/../disk.$$"; exit 1; }
    rm -f "$D/../disk.$$"
}

for ending in exr png tif jpg gif; do
    name=$D/old.$ending
    echo old >"$name"
    many=()
    [ $ending = gif ] && many=(--frames 1-9)
    fails "old.$ending: cannot be written: No space left on device" -o "$name" --size 800x600 "${many[@]}"
    [ "$(cat "$name")" = old ] && [ "$(ls -A "$D")" = "old.$ending" ]
    rm "$name"
done
echo "a full disk: no part of a file, no old file lost, in five formats"

mount -o remount,ro "$D"
fails "Read-only file system" -o "$D/a.png" --size 32x24
mount -o remount,rw "$D"
echo "a folder that may not be written: refused"

mount -o remount,size=64m "$D" # the frames until then must not fill it
mkdir "$D/gone"
"$proxima" render "$scene" -o "$D/gone/a.####.png" --frames 1-9999 --size 32x24 --device cpu --progress none \
    2>"$D/error" &
pid=$!
for _ in $(seq 200); do
    [ -e "$D/gone/a.0001.png" ] && break
    sleep 0.05
done
mv "$D/gone" "$D/elsewhere" # at once, unlike removing it while files are made in it
code=0
wait $pid || code=$?
grep -q 'cannot be written: No such file or directory' "$D/error" && [ $code -eq 3 ] || { cat "$D/error"; exit 1; }
echo "a folder that vanishes: the run ends with exit code 3 and the file's name"
