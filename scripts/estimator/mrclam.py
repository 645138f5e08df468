"""The State Estimator's filter on MRCLAM, against cameras and beside a textbook filter: rows for scripts/recordings."""
import contextlib
import io

import numpy as np
import recordings


def modelled(name, answers):
    """The World Modeler's LANDMARKS: today's error is that of the wheels alone, as no service fed landmarks to the estimator."""
    none, known, learnt = (np.mean([each[k] for each in answers], axis=0) for k in (2, 3, 4))
    half = "≤ %.4f" % (none[0] / 2)
    return [dict(name=name, metric="wheels alone, position RMS [m]", value=none[0], goal=""),
            dict(name=name, metric="LANDMARKS known beforehand, position RMS [m], half of the wheels' as goal", value=known[0], goal=half),
            dict(name=name, metric="LANDMARKS known beforehand, within 3 sigma [%]", value=known[2], goal="≥ 90"),
            dict(name=name, metric="LANDMARKS first seen by the vehicle, position RMS [m], half of the wheels' as goal", value=learnt[0], goal=half),
            dict(name=name, metric="LANDMARKS first seen by the vehicle, within 3 sigma [%]", value=learnt[2], goal="≥ 90")]


def rows(java, folder, work):
    answers, table = [], []
    for data in sorted(folder.glob("MRCLAM_Dataset*")):
        if not (data / "Robot1_Groundtruth.dat").exists():
            table.append(dict(name=data.name, metric="", value="not judged: it has no ground truth", goal=""))
            continue
        with contextlib.redirect_stdout(io.StringIO()):
            answers += recordings.mrclam(java, data, work)
    if answers:
        own, textbook = np.mean([each[0] for each in answers], axis=0), np.mean([each[1] for each in answers], axis=0)
        name = "MRCLAM, mean of %d robots" % len(answers)
        table += [dict(name=name, metric="position RMS [m], textbook EKF's as goal", value=own[0], goal="≤ %.4f" % textbook[0]),
                  dict(name=name, metric="heading RMS [deg], textbook EKF's as goal", value=own[1], goal="≤ %.2f" % textbook[1]),
                  *modelled(name, answers),
                  dict(name="MRCLAM, worst robot", metric="within 3 sigma [%]", value=min(each[0][2] for each in answers), goal="≥ 90")]
    return table
