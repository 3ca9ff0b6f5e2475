#!/usr/bin/env bash
#SBATCH --job-name=heckbert
#SBATCH --array=1-8
#SBATCH --cpus-per-task=4
#SBATCH --requeue
# A render as a job array: task i of n traces part i/n of the samples. Parts are kept beside the output; the task that
# finds all of them there merges them, to the same bytes that one machine would have made.
#
# Usage: sbatch --array=1-16 slurm-array.sh SCENE OUT.paths.exr [option of 'heckbert render' ...]
#
# A task that fails loses its part and nothing else: submit its number again, with PARTS=16 in the environment. A task
# that is killed or preempted goes on from its last checkpoint.
set -euo pipefail
heckbert=${HECKBERT:-heckbert}
scene=$1 out=$2
shift 2
parts=${PARTS:-$SLURM_ARRAY_TASK_COUNT}
part() { printf '%s.part-%d-of-%d' "$out" "$1" "$parts"; }

mine=$(part "$SLURM_ARRAY_TASK_ID")
resume=()
[ -e "$mine.unfinished" ] && resume=(--resume "$mine.unfinished")
"$heckbert" render "$scene" "$@" --part "$SLURM_ARRAY_TASK_ID/$parts" --threads "${SLURM_CPUS_PER_TASK:-0}" \
  --record "$mine.unfinished" --checkpoint 60 "${resume[@]}"
mv "$mine.unfinished" "$mine"

all=()
for ((i = 1; i <= parts; ++i)); do
  [ -e "$(part "$i")" ] || exit 0
  all+=("$(part "$i")")
done
"$heckbert" merge "${all[@]}" -o "$out"
