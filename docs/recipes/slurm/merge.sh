#!/usr/bin/env bash
# Merges the parts that an array of part.sh wrote. The exit status is that of the check of all maps.
# Usage: merge.sh OUT PARTS
set -euo pipefail

out=$1 parts=$2
files=()
for ((part = 1; part <= parts; ++part)); do
  files+=("$out/part-$part-of-$parts.json")
done

"${MAPWRIGHT:-mapwright}" report merge "${files[@]}" --quiet --format json -o "$out/report.json" || true
"${MAPWRIGHT:-mapwright}" report merge "${files[@]}" -o "$out/report.txt"
