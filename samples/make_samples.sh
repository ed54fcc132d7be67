#!/usr/bin/env bash
# Makes the GIS files of the samples from their drawings (*.csv with WKT): a GeoPackage, Shapefiles
# and GeoJSON. Run it after editing a drawing; the same drawings give the same bytes with one
# version of GDAL. Needs ogr2ogr (package gdal-bin).
# Usage: samples/make_samples.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

# No date of today in any file.
export OGR_CURRENT_DATE='2026-01-01T00:00:00.000Z'
dbf_date='DBF_DATE_LAST_UPDATE=2026-01-01'

csv=(-oo AUTODETECT_TYPE=YES -oo GEOM_POSSIBLE_NAMES=WKT -oo KEEP_GEOM_COLUMNS=NO)

# The campus is drawn in metres along its own axes. On the ground it is turned 30 degrees
# counter-clockwise, with the drawing's origin at E 319720, N 4611000 of UTM zone 31 north, where
# that grid's scale is 1: the drawing's round figures are metres on the ground.
cos=0.8660254037844386
sin=0.5
to_ground="+proj=affine +s11=$cos +s12=-$sin +s21=$sin +s22=$cos +xoff=319720 +yoff=4611000"
utm=(-s_srs EPSG:25831 -t_srs EPSG:25831 -ct "$to_ground")

# Directions are attributes, which ogr2ogr does not turn: compass directions of stairs, normals of
# ramps. They count from the north of the source's grid, which in UTM lies 1.438 degrees west of
# true north at the site, so that GeoJSON (longitude, latitude) differs. Shapefile field names have
# at most ten characters.
true_cos=0.8532051208978811
true_sin=0.5215755186678455

turned_normal() { echo "($1*nx - $2*ny) AS nx, ($2*nx + $1*ny) AS ny, nz"; }

campus_fields() {
  local stairs='name, kind, stair_id, steps, rise, in_out'
  case "$1/$2" in
    geojson/ramps) echo "name, kind, $(turned_normal $true_cos $true_sin), in_out" ;;
    */ramps) echo "name, kind, $(turned_normal $cos $sin), in_out" ;;
    geojson/stairs) echo "$stairs, (direction_deg - 31.438) AS direction_deg" ;;
    shp/stairs) echo "$stairs, (direction_deg - 30) AS direction_" ;;
    */stairs) echo "$stairs, (direction_deg - 30) AS direction_deg" ;;
    shp/walls) echo 'name, kind, height, base_height AS base_heigh, in_out' ;;
    shp/buildings) echo 'name, kind, height, in_out, segment_semantic AS segment_se' ;;
    *) echo '*' ;;
  esac
}

# layer OUT FIELDS DRAWING OPTION...: makes a data set of one drawing, or adds a layer to one.
layer() {
  local out=$1 fields=$2 drawing=$3 name
  shift 3
  name=$(basename "$drawing" .csv)
  ogr2ogr -q "$@" "${csv[@]}" -sql "SELECT $fields FROM \"$name\"" -nln "$name" "$out" "$drawing"
}

make_campus() {
  local drawing name
  rm -rf campus/campus.gpkg campus/shp campus/geojson campus/geojson.tmp.gpkg
  mkdir -p campus/shp campus/geojson
  for drawing in campus/drawing/*.csv; do
    name=$(basename "$drawing" .csv)
    layer campus/campus.gpkg "$(campus_fields gpkg "$name")" "$drawing" "${utm[@]}" \
      -f GPKG -update -append -lco GEOMETRY_NAME=geom -lco SPATIAL_INDEX=NO
    layer "campus/shp/$name.shp" "$(campus_fields shp "$name")" "$drawing" "${utm[@]}" \
      -lco "$dbf_date" -lco ENCODING=UTF-8
    layer campus/geojson.tmp.gpkg "$(campus_fields geojson "$name")" "$drawing" "${utm[@]}" \
      -f GPKG -update -append
    ogr2ogr -q -lco RFC7946=YES -lco COORDINATE_PRECISION=9 \
      "campus/geojson/$name.geojson" campus/geojson.tmp.gpkg "$name"
  done
  rm campus/geojson.tmp.gpkg
}

# The square is drawn in the report's own frame, and its files state no coordinate system. The
# converter numbers obstacles in the order of the layers' names, so that arcade and fittings give
# columns 1 and 2 and bench 13 the numbers the report prints.
make_fib_square() {
  local drawing name
  rm -rf fib_square/fib_square.gpkg fib_square/shp
  mkdir -p fib_square/shp
  for drawing in fib_square/drawing/*.csv; do
    name=$(basename "$drawing" .csv)
    layer fib_square/fib_square.gpkg '*' "$drawing" \
      -f GPKG -update -append -lco GEOMETRY_NAME=geom -lco SPATIAL_INDEX=NO
    layer "fib_square/shp/$name.shp" '*' "$drawing" -lco "$dbf_date" -lco ENCODING=UTF-8
  done
}

make_campus
make_fib_square
