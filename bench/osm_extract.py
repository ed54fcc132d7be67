#!/usr/bin/env python3
"""Writes an OpenStreetMap extract of N houses, four nodes and one way each, to measure its reading.

usage: osm_extract.py N FILE.osm.gz [KEYS]

With KEYS, each way has one more tag, whose key is one of so many: extracts of cities have thousands.
"""
import gzip
import math
import sys

SPACING_DEG = 3e-4
CORNERS_DEG = ((0, 0), (2e-4, 1e-5), (1.9e-4, 2.1e-4), (-1e-5, 2e-4))
PARALLEL = 1 / math.cos(math.radians(41.3))  # right angles stay right


def write_nodes(out, houses):
    columns = math.isqrt(houses) + 1
    number = 0
    for house in range(houses):
        lon = 2.1 + house % columns * SPACING_DEG * PARALLEL
        lat = 41.3 + house // columns * SPACING_DEG
        for x, y in CORNERS_DEG:
            number += 1
            out.write(f'<node id="{number}" lat="{lat + y:.7f}" lon="{lon + x * PARALLEL:.7f}"/>\n')


def write_ways(out, houses, keys):
    for house in range(houses):
        first = 4 * house + 1
        refs = "".join(f'<nd ref="{n}"/>' for n in (*range(first, first + 4), first))
        more = f'<tag k="key{house % keys}" v="x"/>' if keys else ""
        out.write(f'<way id="{house + 1}">{refs}<tag k="building" v="yes"/>'
                  f'<tag k="height" v="7"/>{more}</way>\n')


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    houses = int(sys.argv[1])
    keys = int(sys.argv[3]) if len(sys.argv) == 4 else 0
    with gzip.open(sys.argv[2], "wt") as out:
        out.write('<?xml version="1.0"?>\n<osm version="0.6">\n')
        write_nodes(out, houses)
        write_ways(out, houses, keys)
        out.write("</osm>\n")


main()
