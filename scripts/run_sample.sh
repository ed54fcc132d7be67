#!/usr/bin/env bash
# The main job on the bundled sample: GIS layers become a map, a simulated robot proves it, pictures
# and a page show what came out. Takes about a minute.
# Usage: scripts/run_sample.sh [PROGRAM [FOLDER]]
#   PROGRAM  the built program (default: build/release/cli/mapwright)
#   FOLDER   where to write (default: out)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:-build/release/cli/mapwright}
out=${2:-out}
map=$out/campus.txt
page=$out/index.html

escaped() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g'; }

# Says what is done next, here and on the page.
chapter() {
  printf '\n== %s\n' "$1"
  printf '<h2>%s</h2>\n' "$1" >>"$page"
  if [ $# -gt 1 ]; then printf '<p>%s</p>\n' "$2" >>"$page"; fi
}

# Runs the program; its words go to the terminal and, with the command, to the page.
run() {
  printf '<pre><b>mapwright %s</b>\n' "$(printf '%s ' "$@" | escaped)" >>"$page"
  "$program" "$@" 2>&1 | tee "$out/.words"
  escaped <"$out/.words" >>"$page"
  printf '</pre>\n' >>"$page"
}

# Runs the program with --format json and keeps the answer in a file, for pictures.
answer() {
  local file=$1
  shift
  "$program" "$@" --format json >"$out/$file"
}

picture() {
  local file=$1 caption=$2
  shift 2
  "$program" render "$@" -o "$out/$file" --quiet
  printf '<figure><a href="%s"><img src="%s" alt="%s"></a><figcaption>%s</figcaption></figure>\n' \
    "$file" "$file" "$caption" "$caption" >>"$page"
}

mkdir -p "$out"
cat >"$page" <<'HTML'
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>mapwright: from GIS layers to a proven robot map</title>
<style>
  :root { color-scheme: light dark; }
  body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
  pre { overflow-x: auto; padding: .7rem 1rem; border-radius: .4rem; background: rgb(128 128 128 / 12%); }
  figure { margin: 1rem 0; }
  img { max-width: 100%; background: white; border-radius: .4rem; }
  figcaption { font-size: .9rem; opacity: .8; }
</style>
<h1>From GIS layers to a proven robot map</h1>
<p>Made by <code>scripts/run_sample.sh</code> from the sample <code>samples/campus</code>.</p>
HTML

chapter 'Convert' \
  'GIS layers in UTM become a map in metres along its own axes. Every feature is accounted for.'
run convert samples/campus/campus.gpkg -o "$map" --rules mapwright \
  --origin 319720,4611000 --origin-crs EPSG:25831 --heading -30 --report "$out/ledger.json"
picture map.png 'Colours show kinds of obstacles, strokes the free side, numbers the height in metres.' \
  "$map" --title 'Campus'
for format in svg pdf; do
  "$program" render "$map" -o "$out/map.$format" --title 'Campus' --quiet
done

chapter 'Validate' 'What is wrong with the map, and below with one that a hand has edited.'
run validate "$map"
run info "$map"
answer broken.json validate samples/broken/square_broken.txt --quiet || true  # it has findings
picture broken.png 'Findings in samples/broken/square_broken.txt, a map edited by hand.' \
  samples/broken/square_broken.txt --overlay "$out/broken.json" --labels none

chapter 'Localize' 'A robot that does not know where it is finds out from laser scans.'
localization=(localize "$map" --pose '40,30,90' --iterations 8 --seed 1)
run "${localization[@]}"
answer localize.json "${localization[@]}" --with-particles
picture localize.png 'What the laser sees, particles, true and estimated pose after eight scans.' \
  "$map" --overlay "$out/localize.json" --labels none --bbox 22,22,62,54

chapter 'Plan' 'A way across the campus for a robot of 30 cm radius.'
plan=(plan "$map" --start '10,5' --goal '100,52' --radius 0.3 --planner rrt --seed 4)
run "${plan[@]}"
answer plan.json "${plan[@]}" --with-tree
picture plan.png 'The random tree, the path as found, and smoothed.' \
  "$map" --overlay "$out/plan.json" --labels none

chapter 'Check' 'The verdict before the map goes to a robot.'
run check "$map" --jobs 0

rm -f "$out/.words"
printf '\nDone. Open %s (map: %s, pictures beside it).\n' "$page" "$map"
