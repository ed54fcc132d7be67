#!/usr/bin/env bash
# Checks many generated maps in every way a batch can be run and compares the reports byte by byte:
# 1 and 2 jobs; 1, 3 and 10 shards, merged; killed at random (kill -9) and resumed until it is done.
# Prints the wall-clock time of each. Exit status 1 if two reports differ.
# Usage: bench/batch.sh MAPWRIGHT MAKE_MAPS [MAPS (default 1000)] [OPTIONS of mapwright check]
set -euo pipefail

usage="usage: $0 MAPWRIGHT MAKE_MAPS [MAPS] [OPTIONS]"
mapwright=$(realpath "${1:?$usage}")
make_maps=$(realpath "${2:?$usage}")
count=${3:-1000}
options=("${@:4}")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$make_maps" maps "$count"

# check OPTIONS...: maps that fail are no failure here.
check() {
  local status=0
  "$mapwright" check maps --recursive --quiet "${options[@]}" "$@" || status=$?
  [ "$status" -le 1 ]
}

# compare WHAT FILE: with the report of one job.
compare() {
  if cmp -s whole.json "$2"; then echo "$1: same $(stat -c %s "$2") bytes, $SECONDS s"; else
    echo "$1: DIFFERENT"
    exit 1
  fi
}

SECONDS=0
check --format json -o whole.json
compare "1 job" whole.json

SECONDS=0
check --jobs 2 --format json -o two.json
compare "2 jobs" two.json

for parts in 1 3 10; do
  SECONDS=0
  for ((part = 1; part <= parts; ++part)); do
    check --jobs 2 --shard "$part/$parts" --format json -o "part-$part-of-$parts.json"
  done
  "$mapwright" report merge part-*-of-"$parts".json --quiet --format json -o merged.json || true
  compare "$parts shards" merged.json
done

SECONDS=0
kills=0
until [ -e resumed.json ]; do
  "$mapwright" check maps --recursive --quiet "${options[@]}" --jobs 2 \
    --journal journal --resume --format json -o resumed.json &
  run=$!
  sleep "$((RANDOM % 2)).$((RANDOM % 9 + 1))"
  if kill -9 "$run" 2>/dev/null; then kills=$((kills + 1)); fi
  wait "$run" 2>/dev/null || true
done
compare "killed $kills times and resumed" resumed.json
echo "$(wc -l <journal) lines in the journal of $count maps"
