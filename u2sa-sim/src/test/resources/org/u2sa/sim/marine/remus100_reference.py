"""Writes remus100_reference.csv: runs of the REMUS 100 of PythonVehicleSimulator
(github.com/cybergalactic/PythonVehicleSimulator at c717e073, vehicles/remus100.py; MIT), as its own
main loop steps it, every 0.02 s. Needs numpy and matplotlib.

    PYTHONPATH=PythonVehicleSimulator/src python3 remus100_reference.py > remus100_reference.csv

Angles and rates in rad and rad/s; rpm is the propeller's; NED from the start. In still water: in a
current its propeller's advance goes by the speed over ground.
"""
import math

import numpy as np
from python_vehicle_simulator.lib.gnc import attitudeEuler
from python_vehicle_simulator.vehicles.remus100 import remus100

STEP = 0.02
EVERY_S = 10
RUNS = [
    # name, rudder [deg], stern plane [deg], rpm, seconds
    ("ahead 1200", 0.0, 0.0, 1200.0, 60),
    ("ahead 1525", 0.0, 0.0, 1525.0, 60),
    ("ahead 600", 0.0, 0.0, 600.0, 120),
    ("rudder 5", 5.0, 0.0, 1200.0, 60),
    ("rudder -10", -10.0, 0.0, 1525.0, 60),
    ("dive", 0.0, 1.0, 1200.0, 60),
    ("spiral", 5.0, -2.0, 1525.0, 60),
]

print("run,t,rudder,sternplane,rpm,north,east,down,phi,theta,psi,u,v,w,p,q,r")
for name, rudder, plane, rpm, seconds in RUNS:
    vehicle = remus100("stepInput", 0, 0, 0, 0, 0)
    eta = np.zeros(6)
    nu = np.zeros(6)
    actual = np.zeros(3)
    control = np.array([math.radians(rudder), math.radians(plane), rpm])
    for i in range(round(seconds / STEP) + 1):
        if i > 0 and i % round(EVERY_S / STEP) == 0:
            values = [rudder, plane, rpm, *eta, *nu]
            print(f"{name},{i * STEP:g}," + ",".join(f"{v:.6g}" for v in values))
        nu, actual = vehicle.dynamics(eta, nu, actual, control, STEP)
        eta = attitudeEuler(eta, nu, STEP)
