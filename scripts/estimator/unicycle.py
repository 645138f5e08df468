"""The judge of the ground vehicle's filter: a textbook extended Kalman filter of x, y and heading that is driven by speed and turn
rate and corrected by ranges and bearings of landmarks (Thrun, Burgard and Fox, Probabilistic Robotics, 2005, chapters 5 and 7).
It reads the same lines as Replay."""
import math

import numpy as np

GATE = 16.0  # squared Mahalanobis distance


def wrapped(angle):
    return (angle + math.pi) % (2 * math.pi) - math.pi


def ahead(x, p, dt, drive):
    speed, turn, speed_sigma, turn_sigma = drive
    c, s = math.cos(x[2]), math.sin(x[2])
    f = np.array([[1.0, 0.0, -speed * s * dt], [0.0, 1.0, speed * c * dt], [0.0, 0.0, 1.0]])
    g = np.array([[c * dt, 0.0], [s * dt, 0.0], [0.0, dt]])
    moved = x + np.array([speed * c * dt, speed * s * dt, turn * dt])
    return moved, f @ p @ f.T + g @ np.diag([speed_sigma ** 2, turn_sigma ** 2]) @ g.T


def corrected(x, p, numbers):
    east, north, distance, bearing, distance_sigma, bearing_sigma = numbers
    dx, dy = east - x[0], north - x[1]
    squared = dx * dx + dy * dy
    far = math.sqrt(squared)
    innovation = np.array([distance - far, wrapped(bearing - math.atan2(dy, dx) + x[2])])
    h = np.array([[-dx / far, -dy / far, 0.0], [dy / squared, -dx / squared, -1.0]])
    s = h @ p @ h.T + np.diag([distance_sigma ** 2, bearing_sigma ** 2])
    if innovation @ np.linalg.solve(s, innovation) > GATE:
        return x, p
    k = p @ h.T @ np.linalg.inv(s)
    return x + k @ innovation, (np.eye(3) - k @ h) @ p


def track(lines):
    """Rows of time [s], x, y, heading (counter-clockwise from east), and their variances."""
    out, last, drive = [], 0.0, (0.0, 0.0, 0.1, 0.2)
    for line in lines:
        words = line.split()
        t = int(words[1]) * 1e-6
        fields = {k: float(v) for k, v in (w.split("=") for w in words[4:])} if words[0] == "S" else {}
        if "x" in fields:
            x = np.array([fields["x"], fields["y"], fields["psi"]])
            p = np.diag([fields[k] ** 2 for k in ("xSigma", "ySigma", "psiSigma")])
        else:
            if fields:
                drive = tuple(fields[k] for k in ("xDot", "psiDot", "xDotSigma", "psiDotSigma"))
            x, p = ahead(x, p, t - last, drive)
            if words[0] == "L":
                x, p = corrected(x, p, [float(w) for w in words[3:]])
        last = t
        out.append((t, *x, *np.diag(p)))
    return np.array(out)
