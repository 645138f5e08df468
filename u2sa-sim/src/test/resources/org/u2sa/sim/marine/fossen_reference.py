"""Writes blue_rov2_reference.csv: runs of the BlueROV2's model by the functions of PythonVehicleSimulator
(github.com/cybergalactic/PythonVehicleSimulator, lib/gnc.py: m2c, gvect, Rzyx, Tzyx; MIT) and SciPy's integrator.

    PYTHONPATH=PythonVehicleSimulator/src/python_vehicle_simulator/lib python3 fossen_reference.py > blue_rov2_reference.csv
"""
import numpy as np
from scipy.integrate import solve_ivp
from gnc import Rzyx, Tzyx, gvect, m2c, Smtrx

m, g = 11.5, 9.80665
W, B = m * g, 114.8
rg, rb = np.array([0, 0, 0.02]), np.zeros(3)
MRB = np.zeros((6, 6))
MRB[:3, :3] = m * np.eye(3)
MRB[:3, 3:] = -m * Smtrx(rg)
MRB[3:, :3] = m * Smtrx(rg)
MRB[3:, 3:] = 0.16 * np.eye(3)
MA = np.diag([5.5, 12.7, 14.57, 0.12, 0.12, 0.12])
M = MRB + MA
Minv = np.linalg.inv(M)
DL = np.array([4.03, 6.22, 5.18, 0.07, 0.07, 0.07])
DQ = np.array([18.18, 21.66, 36.99, 1.55, 1.55, 1.55])
h = np.sqrt(0.5)
AT = np.array([[.156, .111, 0], [.156, -.111, 0], [-.156, .111, 0], [-.156, -.111, 0], [0, .111, 0], [0, -.111, 0]])
TO = np.array([[h, -h, 0], [h, h, 0], [h, h, 0], [h, -h, 0], [0, 0, 1], [0, 0, 1]])
T = np.vstack([TO.T, np.cross(AT, TO).T])
LAG = 0.1

def thrust(command):
    beyond = (abs(command) - 0.04) / 0.96
    return 0.0 if beyond <= 0 else (40.0 if command > 0 else -30.0) * min(1.0, beyond) ** 2

def run(name, commands, current, heading):
    target = np.array([thrust(c) for c in commands])
    def f(t, s):
        eta, nu, F = s[:6], s[6:12], s[12:]
        tau = T @ F
        C = m2c(MRB, nu) + m2c(MA, nu)
        D = np.diag(DL + DQ * np.abs(nu))
        nudot = Minv @ (tau - C @ nu - D @ nu - gvect(W, B, eta[4], eta[3], rg, rb))
        R = Rzyx(*eta[3:6])
        return np.concatenate([R @ nu[:3] + np.array([*current, 0]), Tzyx(eta[3], eta[4]) @ nu[3:], nudot, (target - F) / LAG])
    s0 = np.zeros(18)
    s0[2] = 50.0
    s0[5] = heading
    s0[6:9] = 0.0
    ts = np.arange(0.0, 15.01, 0.5)
    sol = solve_ivp(f, (0, 15), s0, t_eval=ts, rtol=1e-10, atol=1e-12)
    for i, t in enumerate(ts):
        values = ",".join("%.9g" % v for v in sol.y[:12, i])
        print("%s,%g,%s" % (name, t, values))

print("run,time_s,north_m,east_m,down_m,phi_rad,theta_rad,psi_rad,u_mps,v_mps,w_mps,p_radps,q_radps,r_radps")
run("surge", [0.25, 0.25, 0.25, 0.25, 0, 0], (0, 0), 0.0)
run("all", [0.3, -0.2, 0.25, 0.15, 0.3, -0.2], (0, 0), 0.7)
run("current", [0.15, 0.25, 0.2, 0.1, 0.25, 0.2], (0.3, -0.2), -1.2)
run("yaw", [-0.3, 0.3, 0.3, -0.3, -0.2, -0.2], (0.1, 0.4), 2.0)
