"""Writes hummingbird_reference.csv: runs of the AscTec Hummingbird by rotorpy 3.0.0 (PyPI, MIT), converted from its
forward-left-up axes to north, east, down and forward, right, down.

    pip install rotorpy==3.0.0 && python3 rotorpy_reference.py > hummingbird_reference.csv
"""
import numpy as np
from rotorpy.vehicles.hummingbird_params import quad_params
from rotorpy.vehicles.multirotor import Multirotor
from scipy.spatial.transform import Rotation

FLIP = np.array([1.0, -1.0, -1.0])


def run(name, speeds, wind, seconds):
    vehicle = Multirotor(quad_params, integrator_kwargs={"method": "DOP853", "rtol": 1e-10, "atol": 1e-12})
    vehicle.weight = np.array([0, 0, -vehicle.mass * 9.80665])
    state = {"x": np.zeros(3), "v": np.zeros(3), "q": np.array([0, 0, 0, 1.0]), "w": np.zeros(3),
             "wind": np.array(wind) * FLIP, "rotor_speeds": np.zeros(4)}
    for i in range(int(round(seconds / 0.1)) + 1):
        if i:
            state = vehicle.step(state, {"cmd_motor_speeds": np.array(speeds, float)}, 0.1)
        body = Rotation.from_quat(state["q"]).as_matrix() * np.outer(FLIP, FLIP)
        roll, pitch, yaw = np.arctan2(body[2, 1], body[2, 2]), -np.arcsin(body[2, 0]), np.arctan2(body[1, 0], body[0, 0])
        row = [0.1 * i, *(state["x"] * FLIP), *(state["v"] * FLIP), roll, pitch, yaw, *(state["w"] * FLIP)]
        print(name + "," + ",".join("%.9g" % value for value in row))


print("run,time_s,north_m,east_m,down_m,north_mps,east_mps,down_mps,phi_rad,theta_rad,psi_rad,p_radps,q_radps,r_radps")
run("hover", [469, 469, 469, 469], [0, 0, 0], 2.0)
run("climb", [560, 560, 560, 560], [0, 0, 0], 2.0)
run("yaw", [480, 458, 480, 458], [0, 0, 0], 2.0)
run("tilt", [470, 468, 472, 471], [0, 0, 0], 1.0)
run("wind", [480, 480, 480, 480], [4.0, -3.0, 0.0], 2.0)
