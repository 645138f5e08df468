#!/usr/bin/env python3
"""Sets U2SA's simulated aircraft beside JSBSim's c172p and prints a Markdown table.

    pip install jsbsim==1.3.3
    ./u2sa --help
    python3 scripts/jsbsim/compare.py                  # <jsbsim>: the same aircraft file
    python3 scripts/jsbsim/compare.py --substeps 10    # JSBSim in steps of 1/1200 s
    python3 scripts/jsbsim/compare.py cessna172        # the built-in Cessna

<jsbsim> is flown from here by Bridge.java, with JSBSim's procedures, and trimmed by Newton's method.
<cessna172> is measured by PerformanceTable.java with procedures of the same effect. JSBSim's aircraft is loaded to
2400 lb by its front seats, which leaves its centre of gravity where it was. It flies at 45 degrees of latitude, where gravity
is the standard one. JSBSim's rudder is positive to the left. Exit code 1: a quantity differs by more than 3 %.
"""

import argparse
import csv
import io
import math
import pathlib
import subprocess
import sys

try:
    import jsbsim
except ImportError:
    sys.exit("jsbsim is not installed: pip install jsbsim==1.3.3")

ROOT = pathlib.Path(__file__).resolve().parents[2]
RATE = 120
TICK = 1.0 / 400.0  # of <jsbsim>
SEAT_LB = (2400.0 - 1500.0 - 200.0) / 2.0  # c172p: 2400 lb with the fuel of its file
FULL_TRIM = 1
WITHIN = 0.03

# Cessna Model 172P, Pilot's Operating Handbook (1982): front page, and section 3 for the glide of 1.5 NM per 1000 ft
HANDBOOK = {
    ("climb", "75 KCAS sea level full throttle", "ft/min"): "700",
    ("glide", "65 KCAS idle", "ft/min"): "-720",
    ("cruise", "8000 ft full throttle", "KTAS"): "120 (leaned)",
    ("cruise", "sea level full throttle", "KTAS"): "123",
    ("stall", "idle flaps 0", "KCAS"): "51",
    ("stall", "idle flaps 30", "KCAS"): "46",
}


def ours(classes):
    command = ["java", "-cp", str(classes), str(ROOT / "scripts/jsbsim/PerformanceTable.java")]
    answer = subprocess.run(command, capture_output=True, text=True)
    if answer.returncode != 0:
        sys.exit(f"{' '.join(command)} failed: {answer.stderr.strip()}\nbuild first: ./u2sa --help")
    rows = csv.DictReader(io.StringIO(answer.stdout))
    return {(r["kind"], r["condition"], r["quantity"]): float(r["value"]) for r in rows}


class Ours:
    """An aircraft of <jsbsim> with the properties of a JSBSim object that the procedures use."""

    bridge = None
    given = {}

    @classmethod
    def connect(cls, classes, name):
        file = pathlib.Path(jsbsim.get_default_root_dir()) / f"aircraft/{name}/{name}.xml"
        command = ["java", "-cp", str(classes), str(ROOT / "scripts/jsbsim/Bridge.java"), str(file)]
        cls.bridge = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
        cls.given = {f"inertia/pointmass-weight-lbs[{i}]": SEAT_LB for i in (0, 1)} if name == "c172p" else {}

    def __init__(self, feet, body, phi=0.0, theta=0.0, psi=0.0, given=None):
        self.inputs = {}
        self.begin(feet, body, phi, theta, psi, given or {})

    def begin(self, feet, body, phi, theta, psi, given):
        numbers = [feet * 0.3048, *(each * 0.3048 for each in body), phi, theta, psi]
        properties = {**self.given, **given}
        self.ask("start " + " ".join(map(repr, numbers)) + "".join(f" {n}={v!r}" for n, v in properties.items()))

    def ask(self, line):
        self.bridge.stdin.write(line + "\n")
        self.bridge.stdin.flush()
        answer = self.bridge.stdout.readline()
        if not answer:
            sys.exit("Bridge.java ended; build first: ./u2sa --help")
        self.state = {name: float(value) for name, value in (each.split("=") for each in answer.split())}

    def __getitem__(self, name):
        return self.inputs.get(name, 0.0) if name.startswith("fcs/") and "cmd" in name else self.state[name.replace("[0]", "")]

    def __setitem__(self, name, value):
        self.inputs[name] = value

    def run(self, seconds=1.0 / RATE):
        names = {"AILERON": "aileron", "ELEVATOR": "elevator", "RUDDER": "rudder", "THROTTLE": "throttle", "FLAPS": "flap"}
        words = []
        for actuator, name in names.items():
            value = self[f"fcs/{name}-cmd-norm"] * (-1.0 if actuator == "RUDDER" else 1.0)
            words.append(f"{actuator}={value!r}")
        self.ask(f"step {seconds!r} " + " ".join(words))

    def do_trim(self, _):
        """Level flight without sideslip, by Newton's method: nothing changes from the first tick to the second."""
        feet, speed, psi = (self[n] for n in ("position/h-sl-ft", "velocities/vt-fps", "attitude/psi-rad"))
        rates = [f"velocities/{axis}" for axis in ("u-fps", "v-fps", "w-fps", "p-rad_sec", "q-rad_sec", "r-rad_sec")]
        engine = {"propulsion/engine/propeller-rpm": 1e3, "propulsion/engine/map-pa": 1e4}

        def changes(x):
            alpha, phi = x[0], x[1]
            theta = math.atan(math.tan(alpha) * math.cos(phi))
            body = (speed * math.cos(alpha), 0.0, speed * math.sin(alpha))
            given = {name: scale * x[6 + i] for i, (name, scale) in enumerate(engine.items())}
            self.begin(feet, body, phi, theta, psi, given)
            for name, value in zip(("elevator", "aileron", "rudder", "throttle"), x[2:6]):
                self[f"fcs/{name}-cmd-norm"] = max(-1.0, min(1.0, value))
            self.run(TICK)
            before = [self[name] for name in (*rates, *engine)]
            self.run(TICK)
            after = [self[name] for name in (*rates, *engine)]
            return [(b - a) / TICK / scale for a, b, scale in zip(before, after, (32, 32, 32, 1, 1, 1, 1e3, 1e4))]

        solve(changes, [0.08, 0.0, 0.0, 0.0, 0.0, 0.6, 2.1, 7.0])


def solve(function, x):
    """Newton's method with differences."""
    for _ in range(20):
        value = function(x)
        if max(map(abs, value)) < 1e-7:
            return
        columns = []
        for i in range(len(x)):
            moved = list(x)
            moved[i] += 1e-5
            columns.append([(b - a) / 1e-5 for a, b in zip(value, function(moved))])
        rows = [[column[i] for column in columns] + [-value[i]] for i in range(len(x))]
        for i in range(len(x)):  # Gauss and Jordan
            pivot = max(range(i, len(x)), key=lambda k: abs(rows[k][i]))
            rows[i], rows[pivot] = rows[pivot], rows[i]
            rows[i] = [each / rows[i][i] for each in rows[i]]
            for k in range(len(x)):
                if k != i:
                    rows[k] = [a - rows[k][i] * b for a, b in zip(rows[k], rows[i])]
        step = [row[-1] for row in rows]
        x = [a + b * min(1.0, 0.3 / max(map(abs, step))) for a, b in zip(x, step)]
    raise jsbsim.TrimFailureError("no trim")


def fly_ours(feet, knots, gamma=0.0, bank=0.0, flaps=0.0, throttle=0.5):
    theirs = fly_theirs(feet, knots, gamma, bank, flaps, throttle)
    fdm = Ours(feet, (theirs["velocities/vt-fps"], 0.0, 0.0), math.radians(bank), math.radians(gamma))
    fdm["fcs/flap-cmd-norm"] = flaps
    fdm["fcs/throttle-cmd-norm"] = throttle
    return fdm


class Theirs(jsbsim.FGFDMExec):
    """JSBSim, in equal steps within a frame of the procedures."""

    substeps = 1

    def run(self):
        for _ in range(self.substeps):
            super().run()


def fly_theirs(feet, knots, gamma=0.0, bank=0.0, flaps=0.0, throttle=0.5, model="c172p"):
    fdm = Theirs(None)
    fdm.set_debug_level(0)
    if not fdm.load_model(model):
        sys.exit(f"JSBSim has no {model}")
    fdm.set_dt(1.0 / RATE / Theirs.substeps)
    fdm["ic/h-sl-ft"] = feet
    fdm["ic/lat-geod-deg"] = 45.0
    fdm["ic/terrain-elevation-ft"] = -10000.0
    fdm["ic/vc-kts"] = knots
    fdm["ic/gamma-deg"] = gamma
    fdm["ic/phi-deg"] = bank
    fdm["ic/psi-true-deg"] = 0.0
    fdm["fcs/flap-cmd-norm"] = flaps
    fdm["fcs/flap-pos-norm"] = flaps
    fdm["fcs/mixture-cmd-norm"] = 1.0
    fdm["fcs/advance-cmd-norm"] = 1.0
    fdm["fcs/throttle-cmd-norm"] = throttle
    for i in (0, 1) if model == "c172p" else ():
        fdm[f"inertia/pointmass-weight-lbs[{i}]"] = SEAT_LB
    fdm.run_ic()
    fdm["propulsion/set-running"] = -1
    return fdm


aircraft = fly_theirs


def trimmed(**start):
    fdm = aircraft(**start)
    try:
        fdm.do_trim(FULL_TRIM)
    except jsbsim.TrimFailureError:
        return None
    return fdm


def power_hp(fdm):
    return fdm["propulsion/engine[0]/power-hp"]


def rpm(fdm):
    return fdm["propulsion/engine[0]/propeller-rpm"]


def level(table):
    for knots in (60, 70, 80, 90, 100, 110):
        condition = f"{knots} KCAS 1000 ft"
        fdm = trimmed(feet=1000.0, knots=knots)
        if fdm is None:
            continue
        table["level", condition, "alpha deg"] = fdm["aero/alpha-deg"]
        table["level", condition, "elevator deg"] = math.degrees(fdm["fcs/elevator-pos-rad"])
        table["level", condition, "power hp"] = power_hp(fdm)
        table["level", condition, "rpm"] = rpm(fdm)


class Pilot:
    """Holds airspeed by pitch, wings level (or a bank), and the ball centred."""

    def __init__(self, fdm, knots=None, feet=None, bank=0.0):
        self.fdm, self.knots, self.feet, self.bank = fdm, knots, feet, math.radians(bank)
        self.integral = 0.0
        self.heeling = 0.0
        self.elevator = fdm["fcs/elevator-cmd-norm"]

    def step(self, elevator=None):
        fdm = self.fdm
        if elevator is None:
            if self.knots is not None:
                error = fdm["velocities/vc-kts"] - self.knots
                wanted = math.radians(5.0) + 0.02 * error + self.integral
                self.integral += 0.001 * error / RATE * 5.0
            else:
                climb = fdm["velocities/h-dot-fps"]
                error = self.feet - fdm["position/h-sl-ft"]
                wanted = math.radians(3.0) + 0.002 * error - 0.004 * climb + self.integral
                self.integral += 0.0005 * error / RATE
            wanted = max(-0.3, min(0.3, wanted))
            elevator = self.elevator - 3.0 * (wanted - fdm["attitude/theta-rad"]) + 0.6 * fdm["velocities/q-rad_sec"]
        fdm["fcs/elevator-cmd-norm"] = max(-1.0, min(1.0, elevator))
        roll = self.bank - fdm["attitude/phi-rad"]
        self.heeling += 0.5 * roll / RATE
        aileron = 3.0 * roll + self.heeling - 0.5 * fdm["velocities/p-rad_sec"]
        fdm["fcs/aileron-cmd-norm"] = max(-1.0, min(1.0, aileron))
        fdm["fcs/rudder-cmd-norm"] = max(-1.0, min(1.0, -2.0 * fdm["aero/beta-rad"]))
        fdm.run()


def seconds(count):
    return range(int(count * RATE))


def climb(table):
    for knots in (65, 75, 85, 95):
        condition = f"{knots} KCAS sea level full throttle"
        fdm = aircraft(feet=0.0, knots=knots, throttle=1.0)
        pilot = Pilot(fdm, knots=knots)
        for _ in seconds(40.0):
            pilot.step()
        # measured about 600 ft above sea level: costs 30 ft/min against our side
        start, time = fdm["position/h-sl-ft"], fdm["simulation/sim-time-sec"]
        for _ in seconds(20.0):
            pilot.step()
        gained = fdm["position/h-sl-ft"] - start
        table["climb", condition, "ft/min"] = gained / (fdm["simulation/sim-time-sec"] - time) * 60.0
        table["climb", condition, "rpm"] = rpm(fdm)


def glide(table):
    fdm = aircraft(feet=2000.0, knots=65.0, throttle=0.0)
    pilot = Pilot(fdm, knots=65.0)
    for _ in seconds(60.0):
        pilot.step()
    start = fdm["position/h-sl-ft"]
    for _ in seconds(20.0):
        pilot.step()
    table["glide", "65 KCAS idle", "ft/min"] = (fdm["position/h-sl-ft"] - start) * 3.0


def cruise(table):
    for feet, name in ((8000.0, "8000 ft"), (0.0, "sea level")):
        fdm = aircraft(feet=feet, knots=100.0, throttle=1.0)
        pilot = Pilot(fdm, feet=feet)
        for _ in seconds(240.0):
            pilot.step()
        table["cruise", f"{name} full throttle", "KTAS"] = fdm["velocities/vtrue-kts"]


def pulse(fdm, name, size, length):
    held = fdm[name]
    fdm[name] = held + size
    for _ in seconds(length):
        fdm.run()
    fdm[name] = held


def swing(samples):
    """Period and damping ratio of a decaying oscillation, from its peaks about the mean of neighbours."""
    peaks = [(t, v) for (_, a), (t, v), (_, b) in zip(samples, samples[1:], samples[2:]) if (v - a) * (b - v) < 0]
    if len(peaks) < 4:
        return None
    spans = [abs(b[1] - a[1]) for a, b in zip(peaks, peaks[1:])]
    period = 2.0 * (peaks[3][0] - peaks[0][0]) / 3.0
    decrement = math.log(spans[0] / spans[2]) / 2.0
    return period, decrement / math.hypot(math.pi, decrement)


def modes(table):
    condition = "100 KCAS 1000 ft"
    fdm = trimmed(feet=1000.0, knots=100.0)
    pulse(fdm, "fcs/elevator-cmd-norm", -0.06, 2.0)
    pilot = Pilot(fdm)
    stick = fdm["fcs/elevator-cmd-norm"]
    samples = []
    for _ in seconds(120.0):
        pilot.step(elevator=stick)
        samples.append((fdm["simulation/sim-time-sec"], fdm["velocities/vtrue-kts"]))
    enter(table, condition, "phugoid", swing(samples[5 * RATE :]))
    fdm = trimmed(feet=1000.0, knots=100.0)
    pulse(fdm, "fcs/rudder-cmd-norm", 0.3, 1.0)
    samples = []
    for _ in seconds(10.0):
        fdm.run()
        samples.append((fdm["simulation/sim-time-sec"], fdm["velocities/r-rad_sec"]))
    enter(table, condition, "Dutch roll", swing(samples))


def enter(table, condition, name, mode):
    if mode is not None:
        table["modes", condition, f"{name} period s"] = mode[0]
        table["modes", condition, f"{name} damping ratio"] = mode[1]


def stall(table):
    for flaps, name in ((0.0, "0"), (1.0, "30")):
        fdm = aircraft(feet=4000.0, knots=65.0, throttle=0.0, flaps=flaps)
        pilot = Pilot(fdm, knots=65.0)
        for _ in seconds(40.0):
            pilot.step()
        stick = fdm["fcs/elevator-cmd-norm"]
        lowest = math.inf
        while stick > -1.0:
            if fdm["velocities/q-rad_sec"] < -0.05:
                break
            lowest = min(lowest, fdm["velocities/vc-kts"])
            stick = max(-1.0, stick - 0.02 / RATE)
            pilot.step(elevator=stick)
        table["stall", f"idle flaps {name}", "KCAS"] = lowest


def turn(table):
    for knots in (80.0, 100.0):
        condition = f"{knots:.0f} KCAS bank 30 deg"
        level_trim = trimmed(feet=1000.0, knots=knots)
        throttle = level_trim["fcs/throttle-cmd-norm"]
        # the throttle that holds the speed in the turn, by repeated flight
        low, high = throttle, 1.0
        for _ in range(12):
            middle = 0.5 * (low + high)
            fdm = aircraft(feet=1000.0, knots=knots, bank=30.0, throttle=middle)
            pilot = Pilot(fdm, feet=1000.0, bank=30.0)
            for _ in seconds(120.0):
                pilot.step()
            if fdm["velocities/vc-kts"] < knots:
                low = middle
            else:
                high = middle
        heading, turned = fdm["attitude/psi-rad"], 0.0
        for _ in seconds(20.0):
            pilot.step()
            now = fdm["attitude/psi-rad"]
            turned += math.remainder(now - heading, 2.0 * math.pi)
            heading = now
        table["turn", condition, "deg/s"] = math.degrees(turned) / 20.0
        table["turn", condition, "power hp"] = power_hp(fdm)
        table["turn", condition, "alpha deg"] = fdm["aero/alpha-deg"]


def measured(fly):
    global aircraft
    aircraft = fly
    table = {}
    for measure in (level, climb, glide, cruise, stall, turn, modes):
        measure(table)
    return table


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="?", choices=("jsbsim", "cessna172"), default="jsbsim")
    parser.add_argument("--classes", default=f"{ROOT}/target/u2sa/lib/*")
    parser.add_argument("--substeps", type=int, default=1, help="JSBSim's steps in 1/120 s")
    arguments = parser.parse_args()
    Theirs.substeps = arguments.substeps
    if arguments.model == "jsbsim":
        Ours.connect(arguments.classes, "c172p")
        mine = measured(fly_ours)
    else:
        mine = ours(arguments.classes)
    theirs = measured(fly_theirs)
    print(f"| kind | condition | quantity | <{arguments.model}> | JSBSim {jsbsim.__version__} c172p | difference | handbook |")
    print("|---|---|---|---:|---:|---:|---:|")
    for key, value in mine.items():
        other = theirs.get(key)
        digits = 0 if abs(value) >= 500 else 1 if abs(value) >= 20 else 2
        beside = "no trim" if other is None else f"{other:.{digits}f}"
        gap = "" if other is None else f"{100.0 * (value / other - 1.0):+.1f} %"
        print(f"| {' | '.join(key)} | {value:.{digits}f} | {beside} | {gap} | {HANDBOOK.get(key, '')} |")
    both = [(value, theirs[key]) for key, value in mine.items() if theirs.get(key) is not None]
    near = sum(abs(value - other) <= WITHIN * abs(other) for value, other in both)
    print(f"\n{near} of {len(both)} quantities are within {WITHIN:.0%} of JSBSim's.")
    return int(near < len(both))


if __name__ == "__main__":
    sys.exit(main())
