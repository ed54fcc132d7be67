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
# true north at the site, so that GeoJSON (longitude, latitude) differs. Shapefile field names have at most
# ten characters.
true_cos=0.8532051208978811
true_sin=0.5215755186678455

turned_normal() { echo "($1*nx - $2*ny) AS nx, ($2*nx + $1*ny) AS ny, nz"; }

fields_of() {
  case "$1/$2" in
    geojson/ramps) echo "name, kind, $(turned_normal $true_cos $true_sin), in_out" ;;
    */ramps) echo "name, kind, $(turned_normal $cos $sin), in_out" ;;
    geojson/stairs)
      echo 'name, kind, stair_id, steps, rise, (direction_deg - 31.438) AS direction_deg, in_out'
      ;;
    shp/stairs) echo 'name, kind, stair_id, steps, rise, (direction_deg - 30) AS direction, in_out' ;;
    */stairs)
      echo 'name, kind, stair_id, steps, rise, (direction_deg - 30) AS direction_deg, in_out'
      ;;
    shp/walls) echo 'name, kind, height, base_height AS base_h, in_out' ;;
    shp/buildings) echo 'name, kind, height, in_out, segment_semantic AS seg_sem' ;;
    *) echo '*' ;;
  esac
}

# layer FORMAT OUT NAME DRAWING OPTION...: makes or extends a data set by one drawing.
layer() {
  local format=$1 out=$2 name=$3 drawing=$4
  shift 4
  ogr2ogr -q "$@" "${csv[@]}" -sql "SELECT $(fields_of "$format" "$name") FROM \"$name\"" \
    -nln "$name" "$out" "$drawing"
}

make_campus() {
  local drawing name
  rm -rf campus/campus.gpkg campus/shp campus/geojson campus/geojson.tmp.gpkg
  mkdir -p campus/shp campus/geojson
  for drawing in campus/drawing/*.csv; do
    name=$(basename "$drawing" .csv)
    layer gpkg campus/campus.gpkg "$name" "$drawing" -f GPKG -update -append "${utm[@]}" \
      -lco GEOMETRY_NAME=geom -lco SPATIAL_INDEX=NO
    layer shp "campus/shp/$name.shp" "$name" "$drawing" -lco "$dbf_date" -lco ENCODING=UTF-8 \
      "${utm[@]}"
    layer geojson campus/geojson.tmp.gpkg "$name" "$drawing" -f GPKG -update -append "${utm[@]}"
    ogr2ogr -q -lco RFC7946=YES -lco COORDINATE_PRECISION=9 \
      "campus/geojson/$name.geojson" campus/geojson.tmp.gpkg "$name"
  done
  rm campus/geojson.tmp.gpkg
}

make_campus
