#!/usr/bin/env bash
# Converts one generated layer of buildings with `mapwright convert` and with `ogr2ogr -t_srs`, in turn,
# and prints the CPU time and the peak memory of each and the ratios. Needs ogr2ogr (package gdal-bin)
# and GNU time (package time).
# Usage: bench/convert_vs_ogr2ogr.sh MAPWRIGHT [BUILDINGS (default 100000)] [ROUNDS (default 3)] [PEERS]
# A building has 5 segments on average: 2000000 BUILDINGS are 10 million. PEERS: gpkg, shp, "gpkg shp"
# (default) or none.
set -euo pipefail

mapwright=${1:?usage: $0 MAPWRIGHT [BUILDINGS] [ROUNDS] [PEERS]}
buildings=${2:-100000}
rounds=${3:-3}
peers=${4:-gpkg shp}
[[ $peers != none ]] || peers=

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Turned L-shaped and rectangular buildings on a grid of 30 m, in UTM zone 31 north.
make_drawing() {
  awk -v n="$buildings" 'BEGIN {
    print "WKT,height,name"
    side = int(sqrt(n)) + 1
    split("0 0 18 0 18 8 9 8 9 16 0 16 0 0", ell, " ")
    split("0 0 18 0 18 12 0 12 0 0", box, " ")
    for (i = 0; i < n; i++) {
      x0 = 428000 + 30 * (i % side); y0 = 4580000 + 30 * int(i / side)
      a = i % 90 * 3.14159265358979 / 180; c = cos(a); s = sin(a)
      text = ""
      m = i % 2 ? 14 : 10
      for (k = 1; k < m; k += 2) {
        x = i % 2 ? ell[k] : box[k]; y = i % 2 ? ell[k + 1] : box[k + 1]
        text = text (k > 1 ? "," : "") sprintf("%.4f %.4f", x0 + c * x - s * y, y0 + s * x + c * y)
      }
      printf "\"POLYGON((%s))\",%d,block %d\n", text, 4 + i % 20, i
    }
  }' >"$folder/drawing.csv"
  ogr2ogr -q -f GPKG "$folder/buildings.gpkg" "$folder/drawing.csv" -nln buildings -a_srs EPSG:25831 \
    -oo GEOM_POSSIBLE_NAMES=WKT -oo KEEP_GEOM_COLUMNS=NO -oo AUTODETECT_TYPE=YES
  rm "$folder/drawing.csv"
}

# measured FILE COMMAND...: appends "user and system time in seconds, peak memory in MB" to FILE. The
# memory is that of the largest process; a source is read in one of its own beside it.
measured() {
  local file=$1
  shift
  command time -a -o "$file.raw" -f '%U %S %M' "$@" >/dev/null 2>&1
  tail -n 1 "$file.raw" | awk '{ printf "%.2f %.0f\n", $1 + $2, $3 / 1024 }' >>"$file"
}

least() { cut -d ' ' -f "$2" "$1" | sort -n | head -n 1; }
most() { cut -d ' ' -f "$2" "$1" | sort -n | tail -n 1; }

make_drawing
frame='+proj=tmerc +lat_0=41.37 +lon_0=2.14 +k=1 +datum=WGS84'
for ((round = 0; round < rounds; round++)); do
  rm -rf "$folder"/out.*
  measured "$folder/mapwright" "$mapwright" convert "$folder/buildings.gpkg" -o "$folder/out.txt" \
    --origin 41.37,2.14 --rules auto
  for peer in $peers; do
    format=$([[ $peer == gpkg ]] && echo GPKG || echo 'ESRI Shapefile')
    measured "$folder/$peer" ogr2ogr -f "$format" -t_srs "$frame" "$folder/out.$peer" "$folder/buildings.gpkg"
  done
done

[[ -s $folder/out.txt ]] || { echo "mapwright wrote no map" >&2; exit 1; }
ours=$(least "$folder/mapwright" 1)
printf '%d buildings, %d segments: least CPU time and greatest memory of %d rounds\n' \
  "$buildings" $((buildings * 5)) "$rounds"
printf 'mapwright convert, validated     %6.2f s  %5d MB\n' "$ours" "$(most "$folder/mapwright" 2)"
for peer in $peers; do
  theirs=$(least "$folder/$peer" 1)
  awk -v peer="$peer" -v ours="$ours" -v theirs="$theirs" -v memory="$(most "$folder/$peer" 2)" 'BEGIN {
    printf "ogr2ogr -t_srs to %-14s %6.2f s  %5d MB, %.2f times our time\n", peer, theirs, memory, theirs / ours }'
done
