#!/usr/bin/env bash
# Draws planning for a point and for robots of 0.3 m and 0.5 m, each in one picture: random tree,
# path as found, smoothed path, shortest path, bottleneck. Prints what the planners answered.
# Usage: scripts/make_planning_pictures.sh MAP.txt START GOAL PREFIX [PROGRAM]
# Writes PREFIX-point.png, PREFIX-0.3m.png, PREFIX-0.5m.png. Places are x,y or names.
#   scripts/make_planning_pictures.sh samples/campus/campus.txt 12.8,13.5 80,68 docs/images/planning
set -euo pipefail
map=$1 start=$2 goal=$3 prefix=$4 program=${5:-build/release/cli/mapwright}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

for radius in 0 0.3 0.5; do
  name=$([[ $radius == 0 ]] && echo point || echo "${radius}m")
  for planner in rrt exact; do
    options=(--start "$start" --goal "$goal" --radius "$radius" --planner "$planner")
    # Status 1 is an answer too: no path, and why.
    "$program" plan "$map" "${options[@]}" --with-tree --format json \
      >"$scratch/$planner.json" || [[ $? == 1 ]]
    printf '%s %s: %s\n' "$name" "$planner" \
      "$("$program" plan "$map" "${options[@]}" | sed -n '1p; /bottleneck/p' | tr '\n' ' ')"
  done
  "$program" render "$map" -o "$prefix-$name.png" --overlay "$scratch/rrt.json" \
    --overlay "$scratch/exact.json" --labels none --width 1100 --quiet
done
