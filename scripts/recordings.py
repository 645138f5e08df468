"""Prints one table of all published recordings: python3 recordings.py --java "java -cp …" DIRECTORY [DATA_SET...]

Each data set has a folder in DIRECTORY and a module with a function rows(java, folder, work) that returns a list of
dict(name, metric, value, goal): value is a number or a text, goal is "≥ 95", "≤ 20" or "" if there is none.

    folder    holds                                   from
    carmen    *.log.gz                                github.com/acschaefer/ple, data/carmen
    landmarks MRCLAM_Dataset*                         as mrclam: the object map
    mrclam    MRCLAM_Dataset*                         github.com/ericguerrero/MUSI-lab-session-1, data
    scanmap   *.log.gz in carmen; carmen-raw/mit-csail.clf of github.com/HobbySingh/Graph-SLAM, 2d_lidar_slam/data, if there
    px4       *.ulg                                   github.com/PX4/pyulog, test
    smartloc  as scripts/estimator/smartloc.py says   github.com/TUC-ProAut/libRSF, datasets/smartLoc
"""
import argparse
import importlib.util
import pathlib
import sys
import tempfile
import traceback

HOME = pathlib.Path(__file__).resolve().parent
# name: module, folder, files, where they come from
DATA = {
    "carmen": ("world/carmen.py", "carmen", "*.log.gz", "github.com/acschaefer/ple, data/carmen"),
    "landmarks": ("world/landmarks.py", "mrclam", "MRCLAM_Dataset*", "github.com/ericguerrero/MUSI-lab-session-1, data"),
    "mrclam": ("estimator/mrclam.py", "mrclam", "MRCLAM_Dataset*", "github.com/ericguerrero/MUSI-lab-session-1, data"),
    "scanmap": ("world/scanmap.py", "carmen", "*.log.gz", "github.com/acschaefer/ple, data/carmen"),
    "px4": ("estimator/px4.py", "px4", "*.ulg", "github.com/PX4/pyulog, test"),
    "smartloc": ("estimator/smartloc.py", "smartloc", "*", "github.com/TUC-ProAut/libRSF, datasets/smartLoc"),
}
MET, MISSED, MISSING = 0, 1, 3


def module(path):
    sys.path.insert(0, str(path.parent))
    spec = importlib.util.spec_from_file_location(path.stem, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def is_met(value, goal):
    """Whether a value reaches its goal; None if there is none."""
    if not goal:
        return None
    sign, bound = goal.split()
    if sign not in ("≥", "≤"):
        raise ValueError("goal %r: expected ≥ or ≤ and a number" % goal)
    return value >= float(bound) if sign == "≥" else value <= float(bound)


def line(row):
    met = is_met(row["value"], row["goal"])
    value = row["value"] if isinstance(row["value"], str) else "%.4g" % row["value"]
    print("| %s | %s | %s | %s | %s |" % (row["name"], row["metric"], value, row["goal"], {True: "met", False: "MISSED", None: ""}[met]), flush=True)
    return MISSED if met is False else MET


def judge(name, java, directory, work):
    source, folder, files, where = DATA[name]
    folder = directory / folder
    if not (folder.is_dir() and any(folder.glob(files))):
        print("| %s | | missing: %s in %s | | %s |" % (name, files, folder, where), flush=True)
        return MISSING
    if not (HOME / source).exists():
        print("| %s | | not judged: there is no scripts/%s | | |" % (name, source), flush=True)
        return MISSING
    try:
        return max([line(row) for row in module(HOME / source).rows(java, folder, work)], default=MISSED)
    except Exception:  # the other data sets are still worth a table
        traceback.print_exc()
        print("| %s | | failed | | |" % name, flush=True)
        return MISSED


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--java", required=True)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("data_set", nargs="*", choices=[[], *DATA])
    arguments = parser.parse_args()
    print("| recording | metric | value | goal | |\n| --- | --- | --- | --- | --- |", flush=True)
    with tempfile.TemporaryDirectory() as work:
        found = [judge(name, arguments.java, arguments.directory, pathlib.Path(work)) for name in arguments.data_set or DATA]
    sys.exit(MISSED if MISSED in found else MISSING if MISSING in found else MET)


if __name__ == "__main__":
    main()
