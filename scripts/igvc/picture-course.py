#!/usr/bin/env python3
"""Makes a course for `./u2sa demo igvc --course` of a picture of its lines from above.

White lines on a dark ground become PolyLines that are painted and judged; barrels may come from a Gazebo
world (SDF), ramps from options. Needs python3-numpy and python3-matplotlib (which reads the picture).

  picture-course.py PICTURE --metres 64 --start 0,22.9,0 --waypoint=15.8,-22.9 [--waypoint=…] [--world FILE]
    [--ramp=3,10,90,5.5,2.5,0.35,1] > course.xml

The middle of the picture is the origin, up is north. Places are east,north [m]; the start's third number is its
direction, anticlockwise from east [deg]. A ramp: its middle, its direction, length from foot to foot, width, height
and length of its flat top [m].
"""
import argparse
import math
import re
import sys

try:
    import numpy
    from matplotlib import image
except ImportError as missing:
    sys.exit(f"this Python has no {missing.name}; expected python3-numpy and python3-matplotlib (Debian) or pip install numpy matplotlib")

LINE_M = 0.0762
STEP_M = 0.18


def traced(mask, step):
    """Chains of (row, column) along the white lines of a mask, a step apart."""
    left = mask.copy()
    chains = []
    while True:
        rows, columns = numpy.nonzero(left)
        if len(rows) == 0:
            return chains
        begin = centre(left, rows[0], columns[0], step / 2)
        ways = []
        for _ in range(2):
            ways.append(walked(left, begin, step))
        chain = ways[1][::-1] + [begin] + ways[0]
        clear(left, begin, 1.2 * step)
        if len(chain) > 3:
            chains.append(chain)


def around(left, at, reach):
    """White pixels within a reach, and how far each is."""
    r0 = max(0, int(at[0] - reach))
    c0 = max(0, int(at[1] - reach))
    rows, columns = numpy.nonzero(left[r0:int(at[0] + reach) + 2, c0:int(at[1] + reach) + 2])
    rows = rows + r0
    columns = columns + c0
    return rows, columns, numpy.hypot(rows - at[0], columns - at[1])


def centre(left, row, column, reach):
    rows, columns, away = around(left, (row, column), reach)
    near = away <= reach
    return float(rows[near].mean()), float(columns[near].mean())


def clear(left, at, reach):
    rows, columns, away = around(left, at, reach)
    left[rows[away <= reach], columns[away <= reach]] = False


def walked(left, begin, step):
    """On from a place as far as the line goes; what is passed is cleared."""
    chain = []
    at = begin
    way = None
    while True:
        rows, columns, away = around(left, at, 1.6 * step)
        ring = (away >= 0.7 * step) & (away <= 1.6 * step)
        if not ring.any():
            return chain
        rows, columns, away = rows[ring], columns[ring], away[ring]
        if way is None:
            best = int(numpy.argmin(away))
        else:
            along = ((rows - at[0]) * way[0] + (columns - at[1]) * way[1]) / away
            best = int(numpy.argmax(along - 0.2 * away / step))
            if along[best] < 0.0:
                return chain
        near = numpy.hypot(rows - rows[best], columns - columns[best]) <= 0.5 * step
        there = (float(rows[near].mean()), float(columns[near].mean()))
        length = math.hypot(there[0] - at[0], there[1] - at[1])
        way = ((there[0] - at[0]) / length, (there[1] - at[1]) / length)
        if chain:
            clear(left, at, 0.75 * step)
        chain.append(there)
        at = there


def place(text):
    return [float(number) for number in text.split(",")]


def points(chain):
    return "; ".join(f"{x:.3f} {y:.3f}" for x, y in chain)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture")
    parser.add_argument("--metres", type=float, required=True, help="width of the picture on the ground")
    parser.add_argument("--start", type=place, required=True)
    parser.add_argument("--waypoint", type=place, action="append", required=True)
    parser.add_argument("--world", help="Gazebo world with models named barrel…")
    parser.add_argument("--ramp", type=place, action="append", default=[], help="east,north,direction,length,width,height,top")
    args = parser.parse_args()
    picture = image.imread(args.picture)
    if picture.ndim == 2:  # shades of grey
        picture = picture[:, :, None]
    bright = picture[:, :, :3].min(axis=2)
    if picture.shape[2] == 4:  # what is transparent shows white
        bright = bright * picture[:, :, 3] + 1.0 - picture[:, :, 3]
    mask = bright > 0.5
    scale = args.metres / mask.shape[1]
    lines = []
    for chain in traced(mask, STEP_M / scale):
        lines.append([((c + 0.5 - mask.shape[1] / 2) * scale, (mask.shape[0] / 2 - r - 0.5) * scale) for r, c in chain])
    if not lines:
        sys.exit(f"{args.picture}: no white line; expected white lines on dark ground")
    out = ['<?xml version="1.0" encoding="UTF-8"?>', "<world>", "  <reference>Local ENU</reference>"]
    x, y, turned = args.start
    ahead = (x + math.cos(math.radians(turned)), y + math.sin(math.radians(turned)))
    out.append(f"  <Line><uid>start</uid><type>start</type><points>{points([(x, y), ahead])}</points></Line>")
    for number, (x, y) in enumerate(args.waypoint, 1):
        out.append(f"  <Circle><uid>waypoint {number}</uid><type>waypoint</type><x>{x}</x><y>{y}</y><z>0</z><radius>2</radius></Circle>")
    for number, line in enumerate(lines, 1):
        for kind in ("white line", "lane boundary"):
            out.append(
                f"  <PolyLine><uid>{kind} {number}</uid><type>{kind}</type><points>{points(line)}</points><width>{LINE_M}</width></PolyLine>"
            )
    if args.world:
        with open(args.world, encoding="utf-8") as file:
            world = file.read()
        poses = re.findall(r"<name>(barrel\w*)</name>.*?<pose>\s*(\S+)\s+(\S+)", world, re.DOTALL)
        for name, x, y in poses:
            out.append(
                f"  <Cylinder><uid>{name}</uid><type>barrel</type><x>{x}</x><y>{y}</y><z>0.5</z><radius>0.3</radius><height>1.0</height></Cylinder>"
            )
    for number, ramp in enumerate(args.ramp, 1):
        if len(ramp) != 7:
            parser.error("--ramp: expected east,north,direction,length,width,height,top")
        x, y, turned, length, width, height, top = ramp
        cos, sin = math.cos(math.radians(turned)), math.sin(math.radians(turned))
        profile = [(-length / 2, 0.0), (-top / 2, height), (top / 2, height), (length / 2, 0.0)]
        text = "; ".join(f"{x + s * cos:.4f} {y + s * sin:.4f} {up}" for s, up in dict.fromkeys(profile))
        out.append(f"  <PolyLine><uid>ramp {number}</uid><type>ramp</type><points>{text}</points><width>{width}</width></PolyLine>")
    print("\n".join(out + ["</world>"]))


if __name__ == "__main__":
    main()
