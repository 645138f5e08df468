"""Scores a flight of ./u2sa demo suas from the formulas alone: python3 suas_score.py RUN...

Reads score-input.csv and compares with summary.json of each run. Shares no code with the judge: the
best ordered sequence is found by recursion over waypoints from the last one backwards.
"""

import json
import math
import sys


def read(path):
    kinds = {}
    for line in open(path, encoding="utf-8"):
        parts = line.rstrip("\n").split(",")
        kinds.setdefault(parts[0], []).append(parts[1:])
    return kinds


def positions(reports):
    """Every 0.1 s between reports at most 5 s apart."""
    all_of_them = []
    for i, (t, *place) in enumerate(reports):
        if i:
            t0, *place0 = reports[i - 1]
            if t - t0 <= 5.0:
                k = 1
                while t0 + 0.1 * k < t - 1e-9:
                    share = 0.1 * k / (t - t0)
                    all_of_them.append([a + share * (b - a) for a, b in zip(place0, place)])
                    k += 1
        all_of_them.append(place)
    return all_of_them


def waypoints(wanted, track):
    """best[j]: most points for the waypoints from i on, by positions from j on."""
    best = [0.0] * (len(track) + 1)
    for waypoint in reversed(wanted):
        gain = [max(0.0, 1.0 - math.dist(waypoint, at) / 30.48) for at in track]
        now = [0.0] * (len(track) + 1)
        for j in reversed(range(len(track))):
            now[j] = max(now[j + 1], gain[j] + best[j])
        best = now
    return best[0] / len(wanted)


def objects(targets, reports):
    def worth(target, report):
        away = math.dist([float(v) for v in target[:2]], [float(v) for v in report[:2]])
        if away >= 45.72:
            return 0.0
        right = sum(a == b for a, b in zip(target[2:], report[2:]))
        return 0.2 * right / 5 + 0.3 * (1.0 - away / 45.72) + 0.3 + 0.2

    pairs = sorted(
        ((worth(t, r), i, j) for i, t in enumerate(targets) for j, r in enumerate(reports)),
        reverse=True,
    )
    seen_targets, seen_reports, total = set(), set(), 0.0
    for value, i, j in pairs:
        if value > 0.0 and i not in seen_targets and j not in seen_reports:
            seen_targets.add(i)
            seen_reports.add(j)
            total += value
    return max(0.0, (total - 0.05 * (len(reports) - len(seen_reports))) / len(targets))


def score(run):
    data = read(run + "/score-input.csv")
    reports = [[float(v) for v in row] for row in data["telemetry"]]
    wanted = [[float(v) for v in row] for row in data["waypoint"]]
    hits = [float(row[0]) for row in data.get("obstacle", [])]
    out, last = 0, -math.inf
    for row in data.get("out", []):
        out += float(row[0]) - last > 10.0
        last = float(row[0])
    gap = (reports[-1][0] - reports[0][0]) / (len(reports) - 1)
    clear = (1.0 - sum(hits) / len(hits)) ** 3 if hits else 1.0
    points = waypoints(wanted, positions(reports))
    return {
        "scoreWaypoints": points,
        "scoreObstacles": clear,
        "scoreObjects": objects(data.get("target", []), data.get("report", [])),
        "boundaryLeft": out,
        "telemetryGapS": gap,
    }


def main():
    worst = 0.0
    for run in sys.argv[1:]:
        summary = json.load(open(run + "/summary.json", encoding="utf-8"))
        for name, value in score(run).items():
            judged = summary[name]
            off = abs(value - judged)
            worst = max(worst, off)
            print(f"{run} {name}: {value:.6f}, judge {judged:.6f}")
    print(f"largest difference {worst:.2e}")
    return 0 if worst < 1e-3 else 1


if __name__ == "__main__":
    sys.exit(main())
