"""The State Estimator's filter on logs of PX4, against EKF2's own answer: rows for scripts/recordings."""
import contextlib
import io

import recordings


def rows(java, folder, work):
    table = []
    for log in sorted(folder.glob("*.ulg")):
        with contextlib.redirect_stdout(io.StringIO()) as words:
            found = recordings.px4(java, log, work)
        table += [dict(name=log.name, metric=metric, value=float(value), goal="") for metric, value in found]
        if not found:
            table.append(dict(name=log.name, metric="", value=words.getvalue().strip().split("**: ")[-1], goal=""))
    return table
