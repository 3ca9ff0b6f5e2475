#!/usr/bin/env bash
# Runs examples/slurm-array.sh as Slurm would, in a row and not in order, and compares with one render of the whole.
# One task fails and is submitted again.
# Usage: fake_slurm.sh EXAMPLE      with the tool in $HECKBERT
set -euo pipefail
example=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
settings=(--size 48x48 --spp 10 --quiet)

task() {
  SLURM_ARRAY_TASK_ID=$1 SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=1 \
    bash "$example" cornell out.paths.exr "${settings[@]}" 2>/dev/null
}
task 3
HECKBERT=false task 1 || echo "task 1 failed"
task 2
ls
task 1
"$HECKBERT" render cornell --record whole.paths.exr "${settings[@]}"
cmp out.paths.exr whole.paths.exr && echo "the same bytes as one render"
