#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Renders an animation as a Slurm job array: each task renders its share of the frames and keeps those that are there,
# so a task that was killed, preempted or requeued goes on where it was. Everything after the script goes to `proxima
# render`:
#
#   sbatch --array=0-15 --cpus-per-task=8 examples/farm/slurm_array.sh orbit.scn -o out/orbit.####.exr --frames 1-480 --cyclic
#
# With GPUs add --gres=gpu:1. $PROXIMA is the program [proxima]. When all tasks are done,
# `proxima verify orbit.scn out/orbit.####.exr --frames 1-480 --cyclic` looks at the whole.
#SBATCH --job-name=proxima
#SBATCH --requeue
#SBATCH --open-mode=append

# Exit code 75, a lost device, is worth another try; RequeueExit=75 in slurm.conf does the same.
"${PROXIMA:-proxima}" render "$@" --shard slurm --skip-existing --progress plain \
    --threads "${SLURM_CPUS_PER_TASK:-1}" &
renderer=$!
trap 'kill -TERM $renderer' TERM INT # a frame in flight is finished or left out whole
wait $renderer
code=$?
while kill -0 $renderer 2>/dev/null; do # a trap ends the first wait
    wait $renderer
    code=$?
done
if [ $code -eq 75 ] && [ "${SLURM_RESTART_COUNT:-0}" -lt 3 ]; then
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
fi
exit $code
