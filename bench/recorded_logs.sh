#!/usr/bin/env bash
# Localization on the recorded logs, with several seeds, against what is asked of it: strict runs of
# 24 stretches, errors, way to convergence (docs/experiments/recorded_logs.md). Prints tables in
# Markdown: median over the seeds, and the worst seed in brackets.
# Usage: bench/recorded_logs.sh MAPWRIGHT [FIRST_SEED LAST_SEED (default 1 5)] [track|search|kidnap ...]
# The logs are looked for in $MAPWRIGHT_TEST_DATA/3_robot (default: ../shared/data/3_robot).
set -euo pipefail
usage="usage: $0 MAPWRIGHT [FIRST_SEED LAST_SEED] [track|search|kidnap ...]"
mapwright=$(realpath "${1:?$usage}")
first_seed=${2:-1}
last_seed=${3:-5}
parts=("${@:4}")
[ ${#parts[@]} -gt 0 ] || parts=(track search kidnap)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
data=${MAPWRIGHT_TEST_DATA:-../shared/data}/3_robot
[ -d "$data" ] || { echo "$data is no folder: set MAPWRIGHT_TEST_DATA" >&2; exit 3; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A run of a stretch has its own seed, the one given and its number: seeds far apart share none.
# localize MAP SOURCE LOG MODE [OPTIONS]: one line a seed, what the command prints at its end.
localize() {
  local name=$1 source=$2 log=$3 mode=$4 seed map=$scratch/${2//\//-}.txt
  shift 4
  [ -e "$map" ] || "$mapwright" import "$data/derived/$source" -o "$map" --quiet 2>/dev/null
  for ((seed = first_seed; seed <= last_seed; ++seed)); do
    "$mapwright" localize "$map" --log "$data/logs/$log-corrected.log.gz" \
      --odometry "$data/derived/$log.odom_ref.csv" --windows "$data/derived/windows/$name.csv" \
      --seed "$((100 * seed))" "$@" >"$scratch/answer" 2>"$scratch/notes" || true
    echo "$(grep -E '^(localized|recovered) ' "$scratch/answer") $(grep 'first scan' "$scratch/notes")"
  done >"$scratch/$name-$mode"
}

# spread FILE WORD WORST FORMAT: median and worst (max or min) of the numbers behind WORD.
spread() {
  sed -nE "s/.*$2 ([0-9.]+).*/\1/p" "$1" | sort -g |
    awk -v worst="$3" -v format="$4" '{ v[NR] = $1 }
      END { if (NR == 0) { print "-"; exit }
            middle = (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2
            printf format " (" format ")", middle, worst == "min" ? v[1] : v[NR] }'
}

# row NAME MODE TITLE BARS: a line of the table; `bars` fills the brackets of the head.
row() {
  local file=$scratch/$1-$2
  printf '| %s | %s | %s | %s | %s | %s | %s |\n' "$3" "$(spread "$file" '^localized' min %.4g)" \
    "$(spread "$file" 'error median' max %.3f)" "$(spread "$file" 'error median [0-9.]+ m, p95' max %.3f)" \
    "$(spread "$file" 'way to it median' max %.1f)" "$(spread "$file" 'others median' max %.2f)" "$4"
}

head_of() {
  echo
  echo "$1"
  echo
  echo '| map | strict of 24 | error median, m | p95, m | way to it, m | a scan, ms | asked |'
  echo '|---|---|---|---|---|---|---|'
}

# each COMMAND: calls it with NAME SOURCE LOG TITLE for each map.
each() {
  "$1" intel_half intel_half.lines.csv intel 'Intel, half'
  "$1" intel_full intel_full.lines.csv intel 'Intel, full'
  "$1" freiburg-101_full freiburg-101_full.lines.csv freiburg-101 'Freiburg 101'
  "$1" seattle_full seattle_full.lines.csv seattle 'Seattle'
  "$1" freiburg-079_half freiburg-079_half.yaml freiburg-079 'Freiburg 079, half, grid'
}

# What is asked: strict, median, 95th percentile; strict, way.
declare -A track_bars=([intel_half]='23; .053; .218' [intel_full]='23; .057; .168'
  [freiburg-101_full]='23; .040; .104' [seattle_full]='23; .026; .081')
declare -A search_bars=([intel_half]='20; way 3' [intel_full]='21; way 5'
  [freiburg-101_full]='23; way 3' [seattle_full]='20; way 3')

track() {
  localize "$1" "$2" "$3" track --from-reference
  row "$1" track "$4" "${track_bars[$1]:--}"
}

search() {
  localize "$1" "$2" "$3" search
  row "$1" search "$4" "${search_bars[$1]:--}"
}

kidnap() {
  localize "$1" "$2" "$3" kidnap --from-reference --kidnap
  local file=$scratch/$1-kidnap
  printf '| %s | %s | %s | %s | %s |\n' "$4" "$(spread "$file" '^recovered' min %.4g)" \
    "$(spread "$file" 'scans to it median' max %.0f)" \
    "$(spread "$file" 'scans to it median [0-9.]+, p95' max %.0f)" \
    "$(spread "$file" 'way to it median' max %.1f)"
}

echo "seeds $first_seed to $last_seed: median (worst)"
for part in "${parts[@]}"; do
  case $part in
    track) head_of 'Tracking from a known start:' ;;
    search) head_of 'Place and heading unknown:' ;;
    kidnap)
      printf '\nCarried off to another stretch, half the table further on, while tracking:\n\n'
      echo '| map | recovered of 24 | scans to it, median | p95 | way to it, m |'
      echo '|---|---|---|---|---|'
      ;;
    *) echo "$usage" >&2; exit 2 ;;
  esac
  each "$part"
done
