#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A real Slurm renders an animation as an array of four tasks, two at once; one is killed and requeued, which takes it
# two minutes. The frames must be those of a plain run, byte by byte. Usage: slurm_test.sh PROXIMA SOURCE_FOLDER
set -eu
proxima=$1
source=$2
here=$(cd "$(dirname "$0")" && pwd)
for program in /usr/sbin/slurmctld /usr/sbin/slurmd /usr/sbin/munged sbatch; do
    if ! command -v $program >/dev/null; then
        echo "skipped: Slurm: there is no $program; apt-get install slurmctld slurmd slurm-client munge"
        exit 77
    fi
done

D=$(mktemp -d /tmp/proxima_slurm.XXXXXX)
export SLURM_CONF=$D/slurm.conf
end() {
    for name in slurmd ctld munge/pid; do
        pid=$(cat "$D/$name.pid" 2>/dev/null || cat "$D/$name" 2>/dev/null || true)
        [ -n "$pid" ] && kill "$pid" 2>/dev/null || true
        sleep 0.5
    done
    rm -rf "$D"
}
trap end EXIT
"$here/slurm_up.sh" "$D"

scene=$source/examples/12_pendulum_wave.scn
frames="--frames 1-24 --cyclic --size 320x240 --samples 4 --device cpu"
mkdir "$D/farm" "$D/plain"
cd "$D"
export PROXIMA=$proxima
job=$(sbatch --parsable --array=0-3%2 --cpus-per-task=1 --output="$D/task_%a.log" \
    "$source/examples/farm/slurm_array.sh" "$scene" -o "$D/farm/f.####.exr" $frames)

# Two tasks at once, and the first one is killed when it has made a frame.
most=0
for _ in $(seq 600); do
    running=$(squeue -h -t R -o %i | wc -l)
    [ "$running" -gt "$most" ] && most=$running
    if [ -e farm/f.0001.exr ] && [ "$most" -ge 2 ]; then break; fi
    sleep 0.1
done
scontrol requeue "${job}_0"
echo "task 0 was killed with $(ls farm | wc -l) frames there"
"$proxima" render "$scene" -o "$D/plain/f.####.exr" $frames --progress none

for _ in $(seq 400); do
    [ -z "$(squeue -h -j "$job")" ] && break
    sleep 1
done
[ -z "$(squeue -h -j "$job")" ] || { echo "the array did not end"; squeue; exit 1; }
restarts=$(scontrol show job -o "${job}_0" | grep -o 'Restarts=[0-9]*' | head -1)
states=$(scontrol show job -o "$job" | grep -o 'JobState=[A-Z]*' | sort | uniq -c | xargs)
echo "at most $most tasks at once; task 0: $restarts; $states"
[ "$most" -eq 2 ]
[ "$restarts" = Restarts=1 ]
[ "$states" = "4 JobState=COMPLETED" ] || { tail -n 5 task_*.log; exit 1; }
[ -z "$(find farm -name '.*.tmp')" ]
diff -r farm plain && echo "24 frames are the same, byte by byte"
"$proxima" verify "$scene" "$D/farm/f.####.exr" $frames
