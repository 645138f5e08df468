"""The State Estimator's filter in an urban canyon: rows for scripts/recordings.

smartLoc (TU Chemnitz, CC BY-SA 4.0; github.com/TUC-ProAut/libRSF, datasets/smartLoc) has a car's pseudoranges, wheel speed and turn
rate against a reference in the streets of Berlin and Frankfurt: *_Input.txt and *_GT.txt. The pseudoranges become positions here as
in a receiver, by least squares over all satellites in view with one clock a system. It weights them by signal strength, as receivers
do (sigma-epsilon model, Hartinger and Brunner 1999), for what comes by reflection is weak, and has no other test for reflections.
Sigmas follow from geometry and from how badly the ranges fit. The filter gets those, the wheels and the gyroscope, and its defaults.

The rows "all satellites alike" are of a solver that does not look at the signals. The mean of all its fixes so far, carried along by
the true motion, is what a filter with perfect wheels and a perfect gyroscope could know from them at best: no filter gets much below.
"""
import math

import numpy as np

import recordings

AXIS, FLATTENING = 6378137.0, 1 / 298.257223563
ECCENTRICITY2 = FLATTENING * (2 - FLATTENING)
EARTH_RATE, LIGHT = 7.2921151467e-5, 299792458.0
FIRST_S = 1.0  # added to every time: the recordings begin at 0
SETTLED_S = 10.0
MAX_HDOP = 20.0  # no receiver calls that a fix
STRONG_DBHZ, STRONG_VARIANCE = 50.0, 25.0  # a strong signal and its range's variance [m²], as the recordings claim it


def table(path, kind):
    return np.array([[float(v) for v in line.split()[1:]] for line in path.read_text().splitlines() if line.startswith(kind + " ")])


def geodetic(p):
    """Latitude and longitude [rad] and height [m] of rows of ECEF (Bowring, 1976, iterated)."""
    x, y, z = np.moveaxis(np.asarray(p), -1, 0)
    across, lat, height = np.hypot(x, y), np.arctan2(z, np.hypot(x, y)), 0.0
    for _ in range(6):
        normal = AXIS / np.sqrt(1 - ECCENTRICITY2 * np.sin(lat) ** 2)
        height = across / np.cos(lat) - normal
        lat = np.arctan2(z, across * (1 - ECCENTRICITY2 * normal / (normal + height)))
    return lat, np.arctan2(y, x), height


def axes(lat, lon):
    """Rows east, north and up in ECEF."""
    sa, ca, so, co = math.sin(lat), math.cos(lat), math.sin(lon), math.cos(lon)
    return np.array([[-so, co, 0.0], [-sa * co, -sa * so, ca], [ca * co, ca * so, sa]])


def by_strength(ranges):
    return STRONG_VARIANCE * 10 ** ((STRONG_DBHZ - ranges[:, 9]) / 10)


def alike(ranges):
    return np.full(len(ranges), np.mean(ranges[:, 2]))


def fix(ranges, guess, variances):
    """Position [ECEF, m] and sigmas [m] east, north and up of one epoch of pseudoranges; None if there is none."""
    systems = sorted(set(ranges[:, 7]))
    if len(ranges) < 4 + len(systems):  # at least one range to spare: the fit says how wrong they are
        return None
    clocks = np.array([[system == each for each in systems] for system in ranges[:, 7]], float)
    x, weight = np.concatenate([guess, np.zeros(len(systems))]), 1 / np.sqrt(variances)
    for _ in range(10):
        delta = ranges[:, 3:6] - x[:3]
        far = np.linalg.norm(delta, axis=1)
        sagnac = EARTH_RATE / LIGHT * (ranges[:, 3] * x[1] - ranges[:, 4] * x[0])
        design = weight[:, None] * np.hstack([-delta / far[:, None], clocks])
        left = weight * (ranges[:, 1] - far - sagnac - clocks @ x[3:])
        step = np.linalg.lstsq(design, left, rcond=None)[0]
        x += step
        if np.linalg.norm(step[:3]) < 1e-3:
            break
    lat, lon, _ = geodetic(x[:3])
    shape = axes(lat, lon) @ np.linalg.inv(design.T @ design)[:3, :3] @ axes(lat, lon).T
    if not np.linalg.norm(step[:3]) < 1.0 or shape[0, 0] + shape[1, 1] > MAX_HDOP ** 2 * np.mean(variances):
        return None
    spread = left @ left / (len(ranges) - len(x))
    return x[:3], np.sqrt(np.diag(shape) * max(spread, 1.0))


def lines(path, near, variances_of):
    """Lines of Replay, and rows of time [s], ECEF [m] and sigma [m] of all fixes."""
    ranges, driven = table(path, "pseudorange3"), table(path, "odom3")
    events, fixes = [], []
    for t in np.unique(ranges[:, 0]):
        epoch = ranges[ranges[:, 0] == t]
        found = fix(epoch, near, variances_of(epoch))
        if found is not None:
            place, (east, north, up) = found
            lat, lon, height = geodetic(place)
            events.append((t, "S %d GPS GLOBAL x=%.9f y=%.9f z=%.3f xSigma=%.3f ySigma=%.3f zSigma=%.3f" % (
                (t + FIRST_S) * 1e6, math.degrees(lon), math.degrees(lat), height, east, north, up)))
            fixes.append((t, *place, math.hypot(east, north)))
    for row in driven:
        events.append((row[0], "S %d Wheels BODY_FLU xDot=%.4f psiDot=%.6f xDotSigma=%.4f psiDotSigma=%.5f" % (
            (row[0] + FIRST_S) * 1e6, row[1], row[6], math.sqrt(row[7]), math.sqrt(row[12]))))
    return [line for _, line in sorted(events, key=lambda each: each[0])], np.array(fixes)


def rows(java, folder, work):
    found = []
    for path in sorted(folder.glob("*_Input.txt")):
        name = path.name.replace("_Input.txt", "")
        found += judged(java, path, work, name, by_strength)
        found += judged(java, path, work, name + ", all satellites alike", alike)
    return found


def judged(java, path, work, name, variances_of):
    truth = table(path.with_name(path.name.replace("_Input", "_GT")), "point3")
    lat0, lon0, height0 = (float(v) for v in geodetic(truth[0, 1:4]))
    turn = axes(lat0, lon0)
    flat = (truth[:, 1:4] - truth[0, 1:4]) @ turn.T
    text, fixes = lines(path, truth[0, 1:4], variances_of)
    ours, _ = recordings.replay(java, "GROUND", text, work, path.stem, needs_position=True)
    t = ours[:, 0] / 1e6 - FIRST_S
    use = (t >= max(truth[0, 0], t[0] + SETTLED_S)) & (t <= truth[-1, 0])
    lat, lon = np.radians(ours[:, 1]), np.radians(ours[:, 2])
    normal = AXIS / np.sqrt(1 - ECCENTRICITY2 * np.sin(lat) ** 2)
    place = np.stack([(normal + height0) * np.cos(lat) * np.cos(lon), (normal + height0) * np.cos(lat) * np.sin(lon),
                      (normal * (1 - ECCENTRICITY2) + height0) * np.sin(lat)], axis=1)

    def off(times, p):
        """Error east and north [m] at each time of positions in ECEF."""
        return ((p - truth[0, 1:4]) @ turn.T)[:, :2] - np.stack([np.interp(times, truth[:, 0], flat[:, k]) for k in (0, 1)], axis=1)
    errors = np.hypot(*off(t, place)[use].T)
    sigma = np.hypot(ours[:, 13], ours[:, 14])[use]
    alone = off(fixes[:, 0], fixes[:, 1:4])
    mean = np.cumsum(alone, axis=0) / np.arange(1, len(alone) + 1)[:, None]
    return [dict(name=name, metric=metric, value=float(value), goal=goal) for metric, value, goal in (
        ("fixes alone, position RMS [m]", recordings.rms(np.hypot(*alone.T)), ""),
        ("fixes alone within 3 sigma [%]", 100 * np.mean(np.hypot(*alone.T) < 3 * fixes[:, 4]), ""),
        ("mean of all fixes so far, by the true motion, position RMS [m]", recordings.rms(np.hypot(*mean[fixes[:, 0] > SETTLED_S].T)), ""),
        ("position RMS [m]", recordings.rms(errors), "≤ 20"),
        ("largest position error [m]", errors.max(), ""),
        ("within 3 sigma [%]", 100 * np.mean(errors < 3 * sigma), "≥ 90"))]
