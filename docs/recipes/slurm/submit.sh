#!/usr/bin/env bash
# Checks a folder of maps as a Slurm job array and merges the parts.
# Usage: submit.sh MAPS OUT PARTS [OPTIONS of mapwright check]
# Prints the number of the job that merges; its exit status is the verdict.
# MAPWRIGHT names the program (default: mapwright in the PATH), which all nodes must have.
set -euo pipefail

maps=$(realpath "${1:?usage: $0 MAPS OUT PARTS [OPTIONS]}")
out=${2:?usage: $0 MAPS OUT PARTS [OPTIONS]}
parts=${3:?usage: $0 MAPS OUT PARTS [OPTIONS]}
shift 3
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
mkdir -p "$out"
out=$(realpath "$out")

array=$(sbatch --parsable --job-name=mapwright-check --array="1-$parts" --requeue \
  --output="$out/part-%a.log" --open-mode=append "$here/part.sh" "$maps" "$out" "$parts" "$@")
sbatch --parsable --job-name=mapwright-merge --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  --output="$out/merge.log" "$here/merge.sh" "$out" "$parts"
