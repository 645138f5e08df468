"""The State Estimator's filter on logs of PX4, against EKF2's own answer: rows for scripts/recordings."""
import contextlib
import io

import recordings


def goal(metric):
    """Attitude within some degrees of EKF2's; the position logs are too short for more."""
    return "≤ 3" if metric.startswith(("roll, pitch", "heading")) else ""


def rows(java, folder, work):
    table = []
    for log in sorted(folder.glob("*.ulg")):
        with contextlib.redirect_stdout(io.StringIO()) as words:
            found = recordings.px4(java, log, work)
        table += [dict(name=log.name, metric=metric, value=float(value), goal=goal(metric)) for metric, value in found]
        if not found:
            table.append(dict(name=log.name, metric="", value=words.getvalue().strip().split("**: ")[-1], goal=""))
    return table
