#!/usr/bin/env python3
"""Flies JSBSim's aircraft and <jsbsim> from the same state with the same commands and prints how far they come apart.

    pip install jsbsim==1.3.3
    ./u2sa --help
    python3 scripts/jsbsim/flights.py [--aircraft J3Cub --speed 0.7]

Each flight lasts 60 s, without any feedback, from level flight as JSBSim trims it. A number is the largest difference in that
time, in percent of the span of JSBSim's values.
"""

import argparse
import math

import jsbsim

import compare
from compare import RATE, Ours

QUANTITIES = {
    "speed": "velocities/vt-fps",
    "height": "position/h-sl-ft",
    "roll": "attitude/phi-rad",
    "pitch": "attitude/theta-rad",
    "heading": "attitude/psi-rad",
    "p": "velocities/p-rad_sec",
    "q": "velocities/q-rad_sec",
    "r": "velocities/r-rad_sec",
    "alpha": "aero/alpha-rad",
    "beta": "aero/beta-rad",
    "rpm": "propulsion/engine[0]/propeller-rpm",
    "power": "propulsion/engine[0]/power-hp",
}


def doublet(t, start, size, length=1.0):
    return size if start <= t < start + length else -size if start + length <= t < start + 2 * length else 0.0


# name: trim speed, height, and commands added to those of the trim
FLIGHTS = {
    "climb": (80, 2000, lambda t: {"throttle": 0.3 if t > 2 else 0.0}),
    "descent": (80, 4000, lambda t: {"throttle": -0.3 if t > 2 else 0.0}),
    "elevator doublet": (90, 2000, lambda t: {"elevator": doublet(t, 2, 0.1)}),
    "aileron doublet": (90, 2000, lambda t: {"aileron": doublet(t, 2, 0.2)}),
    "rudder doublet": (90, 2000, lambda t: {"rudder": doublet(t, 2, 0.3)}),
    "turn": (90, 3000, lambda t: {"aileron": doublet(t, 2, 0.15, 1.5) if t < 3.5 else 0.0}),
    "throttle steps": (90, 2000, lambda t: {"throttle": doublet(t, 5, 0.15, 10.0)}),
    "flaps": (75, 2000, lambda t: {"flap": 0.66 if t > 5 else 0.0}),
}
ENGINE = ("propeller-rpm", "map-pa", "blade-angle")
CONTROLS = ("elevator", "aileron", "rudder", "throttle", "flap")


def pair(name, knots, feet):
    theirs = compare.fly_theirs(feet=feet, knots=knots, model=name)
    theirs.do_trim(compare.FULL_TRIM)
    for axis, control in (("pitch", "elevator"), ("roll", "aileron"), ("yaw", "rudder")):
        theirs[f"fcs/{control}-cmd-norm"] += theirs[f"fcs/{axis}-trim-cmd-norm"]
        theirs[f"fcs/{axis}-trim-cmd-norm"] = 0.0
    theirs.run()
    body = tuple(theirs[f"velocities/{axis}-fps"] for axis in "uvw")
    mine = Ours(
        theirs["position/h-sl-ft"],
        body,
        *(theirs[f"attitude/{name}-rad"] for name in ("phi", "theta", "psi")),
        given={f"propulsion/engine/{name}": theirs[f"propulsion/engine/{name}"] for name in ENGINE},
    )
    return theirs, mine


def flown(name, knots, feet, extra, length=60.0):
    theirs, mine = pair(name, knots, feet)
    held = {name: theirs[f"fcs/{name}-cmd-norm"] for name in CONTROLS}
    rows = []
    for i in range(int(length * RATE)):
        for fdm, frame in ((theirs, i), (mine, i - 1)):  # JSBSim moves a surface one frame after its command
            added = extra(frame / RATE)
            for name in CONTROLS:
                lowest = 0.0 if name in ("throttle", "flap") else -1.0
                fdm[f"fcs/{name}-cmd-norm"] = max(lowest, min(1.0, held[name] + added.get(name, 0.0)))
            fdm.run()
        rows.append([(theirs[name], mine[name]) for name in QUANTITIES.values()])
    return rows


def difference(pairs, is_heading):
    if is_heading:
        pairs = [(0.0, math.remainder(b - a, 2 * math.pi)) for a, b in pairs]
        return math.degrees(max(abs(b) for _, b in pairs))
    theirs = [a for a, _ in pairs]
    scale = max(theirs) - min(theirs)
    return 100.0 * max(abs(b - a) for a, b in pairs) / scale


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--classes", default=f"{compare.ROOT}/target/u2sa/lib/*")
    parser.add_argument("--aircraft", default="c172p", help="one of those that the package jsbsim brings")
    parser.add_argument("--speed", type=float, default=1.0, help="times the speeds, which are the c172p's")
    arguments = parser.parse_args()
    Ours.connect(arguments.classes, arguments.aircraft)
    print("| flight | " + " | ".join(QUANTITIES) + " |")
    print("|---|" + "---:|" * len(QUANTITIES))
    for name, (knots, feet, extra) in FLIGHTS.items():
        rows = flown(arguments.aircraft, arguments.speed * knots, feet, extra)
        cells = [f"{difference([row[i] for row in rows], q == 'heading'):.1f}" for i, q in enumerate(QUANTITIES)]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
