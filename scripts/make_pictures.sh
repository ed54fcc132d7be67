#!/usr/bin/env bash
# Draws the pictures of README.md and docs/ from the samples, into docs/images.
# Usage: scripts/make_pictures.sh [PROGRAM]    (default: build/release/cli/mapwright)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/cli/mapwright}
images=docs/images
campus=samples/campus/campus.txt
square=samples/fib_square/fib_square.txt
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

draw() {
  local file=$1
  shift
  "$program" render "$@" -o "$images/$file" --width 1100 --quiet
}

mkdir -p "$images"

# README: the campus with a path across it and a scan at its start.
"$program" plan "$campus" --start '10,5' --goal '100,52' --radius 0.3 --planner exact --format json \
  >"$scratch/path.json"
draw campus.png "$campus" --title 'A campus, from its GIS layers' --overlay "$scratch/path.json" \
  --scan '62,38,90'

# docs/experiments/map.md: the map (the report's figure 2), stairs from both sides (figure 6).
draw fib_square.png "$square" --title 'The square, from its drawing'
draw circles.png "$campus" --circles --labels none
draw stairs_from_below.png "$square" --bbox 28,34,60,53 --scan '46,48,-90' --labels heights
draw stairs_from_above.png "$square" --bbox 28,34,60,53 --scan '46,37,90' --labels heights
draw ramp_from_below.png "$campus" --bbox 66,36,94,62 --scan '80,39,90'
draw ramp_from_above.png "$campus" --bbox 66,36,94,62 --scan '80,57,-90'

# docs/experiments/planning.md: trees and paths (the report's figures 7 and 8).
for planner in rrt balanced-rrt; do
  "$program" plan "$campus" --start '12.8,13.5' --goal '80,68' --radius 0.3 --planner "$planner" \
    --with-tree --format json >"$scratch/$planner.json"
  draw "$planner.png" "$campus" --overlay "$scratch/$planner.json" --labels none
done

scripts/make_planning_pictures.sh "$campus" 12.8,13.5 80,68 "$images/planning" "$program" >/dev/null

# samples/README.md: what validate says, on the map.
"$program" validate samples/broken/square_broken.txt --format json >"$scratch/findings.json" || true
draw findings.png samples/broken/square_broken.txt --overlay "$scratch/findings.json" \
  --labels none --title 'Findings in a map edited by hand' 2>/dev/null

# docs/cli.md: the HTML report, where there is a browser.
if command -v chromium >/dev/null && command -v chromedriver >/dev/null; then
  "$program" validate samples/broken/square_broken.txt --format html -o "$scratch/report.html" --quiet || true
  for colours in light dark; do
    python3 tests/browser/screenshot.py "$scratch/report.html" "$images/report_$colours.png" \
      '#map=1&finding=3' "$colours"
  done
fi
