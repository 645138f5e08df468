#!/usr/bin/env python3
"""Reads exported files with readers that others wrote (PyPI gpxpy, fastkml, geojson; Python's csv), and says what is in each.

Usage: check-export.py FILE…    .gpx, .kml, .geojson, .csv, or a folder of .csv
"""
import csv
import json
import math
import pathlib
import sys


def gpx(file):
    import gpxpy
    run = gpxpy.parse(file.read_text())
    for track in run.tracks:
        points = [p for s in track.segments for p in s.points]
        print(f"{file}: track {track.name}: {len(points)} points, {track.length_2d():.1f} m long, {points[0].time} to {points[-1].time}")
    print(f"{file}: {len(run.waypoints)} waypoints: {[(w.name, w.description) for w in run.waypoints[:3]]}…")


def kml(file):
    from fastkml import kml as reader
    from fastkml.gx import Track
    from fastkml.utils import find_all
    root = reader.KML.from_string(file.read_text().replace('<?xml version="1.0" encoding="UTF-8"?>', ""), strict=True)
    for place in find_all(root, of_type=reader.Placemark):
        if isinstance(place.kml_geometry, Track):
            items = place.kml_geometry.track_items
            print(f"{file}: track {place.name}: {len(items)} points, first {items[0].coord} at {items[0].when}")
    goals = [p.name for p in find_all(root, of_type=reader.Placemark) if not isinstance(p.kml_geometry, Track)]
    print(f"{file}: {len(goals)} goals: {goals[:3]}…")


def geo_json(file):
    import geojson
    run = geojson.loads(file.read_text())
    if not run.is_valid:
        sys.exit(f"{file}: {run.errors()}")
    for feature in run.features:
        if feature.geometry.type == "LineString":
            print(f"{file}: line {feature.properties['name']}: {len(feature.geometry.coordinates)} places, "
                  f"{len(feature.properties['coordTimes'])} times")
    print(f"{file}: {sum(f.geometry.type == 'Point' for f in run.features)} goals")


def table(file):
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.reader(stream))
    if any(len(row) != len(rows[0]) for row in rows):
        sys.exit(f"{file}: rows of different lengths")
    for row in rows[1:]:
        float(row[0])
        for cell in row[1:]:
            if cell[:1] in "[{" and cell:
                json.loads(cell)
    numbers = [name for i, name in enumerate(rows[0]) if "[" in name and all(r[i] == "" or math.isfinite(float(r[i])) for r in rows[1:])]
    print(f"{file}: {len(rows) - 1} rows of {', '.join(rows[0])}; {len(numbers)} columns of numbers")


readers = {".gpx": gpx, ".kml": kml, ".geojson": geo_json, ".csv": table}
for argument in sys.argv[1:]:
    path = pathlib.Path(argument)
    for one in sorted(path.glob("*.csv")) if path.is_dir() else [path]:
        readers[one.suffix](one)
