#!/usr/bin/env python3
"""Writes the answer of a URG-04LX in the middle of a room, as SCIP 2 says it goes over the line (Hokuyo C-42-03320B).

    python3 scripts/sensors/scip.py > u2sa-drivers/src/test/resources/org/u2sa/drivers/range/room.scip

The golden file of ScipTest, encoded here from the specification and independently of the driver. What a test may ask of it
is printed to standard error.
"""
import math
import sys

FIRST, LAST, FRONT, STEPS = 44, 725, 384, 1024
ERROR = 6  # a distance below 20 mm is an error code


def checked(line):
    """A line with the character that sums it up."""
    return line + chr((sum(map(ord, line)) & 0x3F) + 0x30)


def encoded(value):
    """18 bits in three characters."""
    return "".join(chr((value >> shift & 0x3F) + 0x30) for shift in (12, 6, 0))


def distance(step):
    """To the wall of a room of 6 m by 4 m, with a door on the right [mm]."""
    angle = 2 * math.pi * (step - FRONT) / STEPS
    if -1.9 < angle < -1.3:
        return ERROR
    ahead, left = math.cos(angle), math.sin(angle)
    walls = [3000 / abs(ahead)] if abs(ahead) > 1e-9 else []
    walls += [2000 / abs(left)] if abs(left) > 1e-9 else []
    return round(min(walls))


distances = [distance(step) for step in range(FIRST, LAST + 1)]
data = "".join(map(encoded, distances))
time = checked("0" + encoded(0x2ABCD))  # four characters
lines = ["GD%04d%04d01" % (FIRST, LAST), checked("00"), time]
lines += [checked(data[at : at + 64]) for at in range(0, len(data), 64)]
sys.stdout.write("\n".join(lines) + "\n\n")

seen = [d for d in distances if 20 <= d <= 5600]
print(len(seen), "of", len(distances), "seen; nearest", min(seen), "farthest", max(seen), "ahead", distance(FRONT), file=sys.stderr)
