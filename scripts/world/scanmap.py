"""The scan map on CARMEN lidar logs driven on odometry that drifts, against the logs' corrected poses (CarmenDrift): rows for scripts/recordings.

Odometry is made of the corrected poses, with errors of scale (2 %), heading (0.25°/m, the same all the way), and each step, by a seed,
except where the folder carmen-raw has the robot's own: mit-csail.clf of github.com/HobbySingh/Graph-SLAM, 2d_lidar_slam/data.
Tuned on mit-csail and intel only.
"""
import re
import shlex
import subprocess

TUNED_ON = ("csail", "intel")
FIGURES = re.compile(
    r"odometry mean ([\d.]+) max ([\d.]+) m; state mean ([\d.]+) max [\d.]+ m aligned, [\d.]+ m from the start, (\d+) % within 3 sigma; "
    r"map mean ([\d.]+) max [\d.]+ m; echoes kept ([\d.]+) %; ([\d.]+) ms a scan")


def measured(java, log, raw, is_mapped):
    command = shlex.split(java)
    command[1:1] = ["-Dmap=%s" % str(is_mapped).lower()]
    words = subprocess.run([*command, "org.u2sa.world.scanmap.CarmenDrift", str(log), *raw], check=True, stdout=subprocess.PIPE, text=True).stdout
    return [float(each) for each in FIGURES.search(words).groups()]


def rows(java, folder, work):
    table = []
    for log in sorted(folder.glob("*.log.gz")):
        name = log.name.removesuffix(".log.gz").removesuffix("-corrected")
        own = folder.parent / "carmen-raw" / ("mit-%s.clf" % name)
        raw = [str(own)] if own.exists() else []
        without = measured(java, log, raw, False)
        found = measured(java, log, raw, True)
        name += (", the robot's own odometry" if raw else "") + (", tuned on" if name in TUNED_ON else "")
        table += [dict(name=name, metric=metric, value=value, goal=goal) for metric, value, goal in (
            ("odometry alone, mean error [m]", without[0], ""),
            ("odometry alone, echoes kept [%]", without[5], ""),
            ("state while driving, mean error [m]", found[2], ""),
            ("state within 3 sigma [%]", found[3], ""),
            ("map, mean error of its key scans [m]", found[4], "≤ 0.3"),
            ("echoes kept [%]", found[5], "≥ 90"),
            ("processor time a scan [ms]", found[6], ""))]
    return table
