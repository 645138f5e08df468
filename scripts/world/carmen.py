"""How many echoes of published CARMEN lidar logs stay on the occupancy grid, with beams 1° and 2° apart (CarmenGrid)."""
import re
import shlex
import subprocess

GOALS = {1: "≥ 95", 2: "≥ 92"}
NAMED = ("aces", "edmonton", "fhw", "freiburg-101", "intel")
FIGURES = re.compile(r"([\d.]+) % of \d+ echoes .*?; ([\d.]+) % of the \d+ seen again")


def rows(java, folder, work):
    table = []
    for log in sorted(folder.glob("*.log.gz")):
        name = log.name.removesuffix(".log.gz").removesuffix("-corrected")
        for degrees in (1, 2):
            command = shlex.split(java)
            command[1:1] = ["-Ddeg=%d" % degrees]
            words = subprocess.run([*command, "org.u2sa.world.grid.CarmenGrid", str(log)], check=True, stdout=subprocess.PIPE, text=True).stdout
            kept, standing = (float(each) for each in FIGURES.search(words).groups())
            table.append(dict(name="%s, %d°" % (name, degrees), metric="echoes kept [%]", value=kept, goal=GOALS[degrees] if name in NAMED else ""))
            table.append(dict(name="%s, %d°" % (name, degrees), metric="echoes seen again 20 scans apart kept [%]", value=standing, goal=GOALS[degrees]))
    return table
