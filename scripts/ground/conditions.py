#!/usr/bin/env python3
"""Drives the ground vehicle with unlike motors, loads and ground, and prints the table of docs/ugv.md.

    python3 scripts/ground/conditions.py [RUNS]

RUNS: how many seeds each, 3 by default. Takes some minutes.
"""
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

HOME = pathlib.Path(__file__).resolve().parents[2]
MISMATCHES = [0, 5, 15, 30, 50]
PAYLOADS = [0, 20, 50]


def drive(options, runs):
    """What a cell says: worst cross-track RMS, or how many waypoints were passed."""
    with tempfile.TemporaryDirectory() as out:
        command = [HOME / "u2sa", "demo", "ugv", "--port", "0", "--loops", "1", "--seed", "31", "--runs", str(runs), "--json"]
        done = subprocess.run([*command, "--out", out, *options.split()], capture_output=True, text=True)
    try:
        summary = json.loads(done.stdout)
    except json.JSONDecodeError:
        sys.exit(f"{options}: {done.stderr or done.stdout}")
    each = summary.get("perRun", [summary])
    passed = sum(run["waypointsCaptured"] for run in each)
    planned = sum(run["waypoints"] for run in each)
    if passed < planned:
        return f"{passed} of {planned} waypoints"
    return f"{summary.get('worstCrossTrackRmsM', summary.get('crossTrackRmsM')):.3f}"


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    subprocess.run([HOME / "u2sa", "--help"], stdout=subprocess.DEVNULL, check=True)  # builds it
    rows = [(f"{control}, {ground}", f"--control {control} {options}")
            for control, ground, options in [
                ("pursuit", "level lawn", ""),
                ("pursuit", "concrete", "--surface concrete"),
                ("pursuit", "field", "--surface field"),
                ("pursuit", "5° slope", "--slope 5"),
                ("pursuit", "10° slope", "--slope 10"),
                ("pursuit", "10° hill", "--hill 10"),
                ("proportional", "level lawn", ""),
                ("proportional", "5° slope", "--slope 5"),
            ]]
    cells = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for name, options in rows:
            whole = name == "pursuit, level lawn"
            for mismatch in MISMATCHES if whole else [0, 30]:
                for payload in PAYLOADS:
                    more = f"{options} --mismatch {mismatch} --payload {payload}"
                    cells[name, mismatch, payload] = pool.submit(drive, more, runs)
        print("| control, ground | motors apart |" + "".join(f" +{payload} kg |" for payload in PAYLOADS))
        print("|---|---|" + "---|" * len(PAYLOADS))
        for name, mismatch in dict.fromkeys((name, mismatch) for name, mismatch, _ in cells):
            print(f"| {name} | {mismatch} % |" + "".join(f" {cells[name, mismatch, payload].result()} |" for payload in PAYLOADS), flush=True)


if __name__ == "__main__":
    main()
