#!/usr/bin/env python3
"""Draws docs/images/ground-vehicle.svg from a run of Drive.java. Needs the program built (./u2sa --help does that).

    pip install matplotlib
    python3 scripts/ground/plot.py
"""
import csv
import os
import pathlib
import subprocess

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

HOME = pathlib.Path(__file__).resolve().parents[2]
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "ground", "font.size": 9, "path.simplify_threshold": 0.3})

path = os.environ.get("U2SA_LIB", f"{HOME}/target/u2sa/lib/*")
run = subprocess.run(["java", "-cp", path, HOME / "scripts/ground/Drive.java"], capture_output=True, text=True, check=True)
rows = list(csv.DictReader(run.stdout.splitlines()))


def column(name, every=1):
    return [float(row[name]) for row in rows[::every] if row[name] != ""]


figure, ((place, speed), (compass, volts)) = plt.subplots(2, 2, figsize=(9, 8), layout="constrained")
place.plot(column("phoneE"), column("phoneN"), "x", color="tab:orange", markersize=5, label="phone's GPS, 1 Hz")
place.plot(column("surveyE")[::5], column("surveyN")[::5], ".", color="tab:green", markersize=4, label="survey GPS, every fifth")
place.plot(column("east", 5), column("north", 5), color="black", linewidth=1, label="truth")
place.plot([20], [10], "^", color="tab:red", label="magnetic place")
place.set(xlabel="east [m]", ylabel="north [m]", title="Around a square of 20 m", aspect="equal")
place.legend(loc="center", fontsize=8)

start = [row for row in rows if float(row["t"]) <= 5.0]
t = [float(row["t"]) for row in start]
speed.plot(t, [2.0 * float(row["first"]) for row in start], ":", color="tab:gray", label="command × 2 m/s")
speed.plot(t, [float(row["left"]) for row in start], color="tab:blue", label="left rim")
speed.plot(t, [float(row["speed"]) for row in start], color="black", label="vehicle")
speed.set(xlabel="time [s]", ylabel="[m/s]", title="Start: sliding tyres, then the motors' lag")
speed.legend(loc="lower right", fontsize=8)

compass.plot(column("t", 5), column("compass", 5), color="tab:red", linewidth=0.7)
compass.set(xlabel="time [s]", ylabel="[°]", title="Error of the calibrated compass")
volts.plot(column("t", 5), column("volts", 5), color="tab:purple", linewidth=0.8)
volts.set(xlabel="time [s]", ylabel="[V]", title="Battery")
for axes in (place, speed, compass, volts):
    axes.grid(alpha=0.3)
figure.savefig(HOME / "docs/images/ground-vehicle.svg", metadata={"Date": None})
