#!/usr/bin/env python3
"""Flies config/vehicles/trainer/trainer.xml with JSBSim and writes *_reference.csv: pip install jsbsim==1.3.3; python3 jsbsim_reference.py

From level flight as JSBSim trims it, without feedback. High: doublets of elevator, aileron and rudder, throttle, flaps. Low:
3 m above the ground, a climb, a stall and the dive from it. Each row holds the state and the commands from then until the next
row. At 45 degrees of latitude gravity is the standard one.
"""

import pathlib

import jsbsim

HERE = pathlib.Path(__file__).resolve().parent
TRAINER = HERE.parents[7] / "config/vehicles/trainer"
RATE = 120
ROW_FRAMES = 60
STATE = (
    "simulation/sim-time-sec", "position/h-sl-ft",
    "velocities/u-fps", "velocities/v-fps", "velocities/w-fps",
    "attitude/phi-rad", "attitude/theta-rad", "attitude/psi-rad",
    "velocities/p-rad_sec", "velocities/q-rad_sec", "velocities/r-rad_sec",
    "propulsion/engine/propeller-rpm", "propulsion/engine/power-hp", "propulsion/engine/map-pa", "propulsion/tank/contents-lbs",
)  # fmt: skip
CONTROLS = ("elevator", "aileron", "rudder", "throttle", "flap")
HIGH = {  # seconds: added to the trim's command from then on
    2.0: ("elevator", 0.15), 3.0: ("elevator", -0.15), 4.0: ("elevator", 0.0),
    10.0: ("aileron", 0.3), 11.0: ("aileron", -0.3), 12.0: ("aileron", 0.0),
    16.0: ("rudder", 0.3), 17.0: ("rudder", -0.3), 18.0: ("rudder", 0.0),
    22.0: ("throttle", 0.25), 28.0: ("throttle", -0.25), 34.0: ("flap", 0.6),
}  # fmt: skip
LOW = {
    4.0: ("throttle", 0.3), 12.0: ("throttle", -0.5), 14.0: ("elevator", -0.4), 19.0: ("elevator", 0.0),
    21.0: ("elevator", -0.5), 26.0: ("elevator", 0.0),
}  # fmt: skip


def fly(name, feet, knots, steps, count):
    fdm = jsbsim.FGFDMExec(None)
    fdm.set_debug_level(0)
    if not fdm.load_model_with_paths("trainer", str(TRAINER), str(TRAINER / "engine"), str(TRAINER), False):
        raise SystemExit("JSBSim does not read trainer.xml")
    fdm.disable_output()
    fdm.set_dt(1.0 / RATE)
    fdm["ic/lat-geod-deg"] = 45.0
    fdm["ic/h-sl-ft"] = feet
    fdm["ic/terrain-elevation-ft"] = 0.0
    fdm["ic/vc-kts"] = knots
    fdm["fcs/mixture-cmd-norm"] = 1.0
    fdm["fcs/throttle-cmd-norm"] = 0.6
    fdm.run_ic()
    fdm["propulsion/set-running"] = -1
    fdm["fcs/mixture-cmd-norm"] = 1.0
    fdm.do_trim(1)
    for axis, control in (("pitch", "elevator"), ("roll", "aileron"), ("yaw", "rudder")):
        fdm[f"fcs/{control}-cmd-norm"] += fdm[f"fcs/{axis}-trim-cmd-norm"]
        fdm[f"fcs/{axis}-trim-cmd-norm"] = 0.0
    fdm.run()
    begin = fdm["simulation/sim-time-sec"]
    trim = {each: fdm[f"fcs/{each}-cmd-norm"] for each in CONTROLS}
    rows = [",".join([*STATE, *CONTROLS])]
    for row in range(count):
        time = row * ROW_FRAMES / RATE
        if time in steps:
            control, added = steps[time]
            fdm[f"fcs/{control}-cmd-norm"] = trim[control] + added
        state = [fdm[each] for each in STATE]
        state[0] -= begin
        rows.append(",".join(f"{value:.6g}" for value in state + [fdm[f"fcs/{each}-cmd-norm"] for each in CONTROLS]))
        for _ in range(ROW_FRAMES):
            fdm.run()
    (HERE / f"{name}_reference.csv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    fly("trainer", 2000.0, 80.0, HIGH, 89)
    fly("trainer_low", 10.0, 70.0, LOW, 61)
