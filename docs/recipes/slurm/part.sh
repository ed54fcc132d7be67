#!/usr/bin/env bash
# One task of the array that submit.sh makes: checks the maps of part SLURM_ARRAY_TASK_ID.
# Usage: part.sh MAPS OUT PARTS [OPTIONS of mapwright check]
set -euo pipefail

maps=$1 out=$2 parts=$3
shift 3
part=${SLURM_ARRAY_TASK_ID:?not a task of a job array}
jobs=${CHECK_JOBS:-${SLURM_CPUS_ON_NODE:-1}}

status=0
"${MAPWRIGHT:-mapwright}" check "$maps" --recursive --shard "$part/$parts" --jobs "$jobs" "$@" \
  --journal "$out/part-$part.journal" --resume \
  --format json --output "$out/part-$part-of-$parts.json" || status=$?

# Maps that fail, cannot be read or crash are in the part: the merged report has the verdict.
case $status in
  0 | 1 | 3 | 5) test -s "$out/part-$part-of-$parts.json" ;;
  *) exit "$status" ;;
esac
