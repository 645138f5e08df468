"""Judges the fusing State Estimator's filter by published recordings, and prints a table in Markdown.

    python3 recordings.py --java "java -cp …" [--ulog sample_px4_events.ulg] [--mrclam DIRECTORY]

--ulog    logs of PX4 (github.com/PX4/pyulog, test/: sample_px4_events.ulg, sample.ulg): IMU, magnetometer, GPS and barometer if
          they are there, against EKF2's own answer.
--mrclam  the folder that holds MRCLAM_Dataset6 and 7 (UTIAS; github.com/ericguerrero/MUSI-lab-session-1, data/): odometry and
          landmarks against the cameras' ground truth, beside a textbook filter (unicycle.py) of the same lines.
Needs pyulog, numpy and evo of PyPI.
"""
import argparse
import math
import pathlib
import shlex
import subprocess
import tempfile

import numpy as np

import unicycle

ODOMETRY_S = 0.1
SLOWEST_IMU_S = 0.05


def replay(java, domain, lines, work, name, needs_position=True):
    source, answer = work / (name + ".txt"), work / (name + ".out")
    source.write_text("\n".join(lines) + "\n")
    done = subprocess.run(shlex.split(java) + ["Replay", domain, str(source), str(answer)], check=True, stderr=subprocess.PIPE, text=True)
    rows = [line.split() for line in answer.read_text().splitlines()]
    keep = [r for r in rows if (r[1] == "true" or not needs_position) and r[2] == "true"]
    return np.array([[float(v) for i, v in enumerate(r) if i not in (1, 2)] for r in keep]), done.stderr


def wrapped(angle):
    return (angle + math.pi) % (2 * math.pi) - math.pi


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def ape(stamps, reference, estimate):
    """RMS of the absolute position error [m], without alignment, by evo."""
    from evo.core import metrics
    from evo.core.trajectory import PoseTrajectory3D
    unit = np.tile([1.0, 0.0, 0.0, 0.0], (len(stamps), 1))
    result = metrics.APE(metrics.PoseRelation.translation_part)
    result.process_data((PoseTrajectory3D(reference, unit, stamps), PoseTrajectory3D(estimate, unit, stamps)))
    return result.get_statistic(metrics.StatisticsType.rmse)


def rpe(stamps, reference, estimate, psi_reference, psi_estimate, metres):
    """RMS of the drift over a way of so many metres, by evo."""
    from evo.core import metrics
    from evo.core.trajectory import PoseTrajectory3D

    def quaternions(psi):
        return np.stack([np.cos(psi / 2), np.zeros_like(psi), np.zeros_like(psi), np.sin(psi / 2)], axis=1)
    result = metrics.RPE(metrics.PoseRelation.translation_part, delta=metres, delta_unit=metrics.Unit.meters, all_pairs=False)
    result.process_data((PoseTrajectory3D(reference, quaternions(psi_reference), stamps),
                         PoseTrajectory3D(estimate, quaternions(psi_estimate), stamps)))
    return result.get_statistic(metrics.StatisticsType.rmse)


def at(times, stamps, values):
    return np.interp(times, stamps, values)


def sampled(data):
    """When measurements were made; older logs say only when they were published [µs]."""
    return data["timestamp_sample"] if "timestamp_sample" in data else data["timestamp"]


def place(gps):
    """Longitude and latitude [deg] and altitude above mean sea level [m]; older logs have integers of 1e-7 deg and of mm."""
    if "longitude_deg" in gps:
        return gps["longitude_deg"], gps["latitude_deg"], gps["altitude_msl_m"]
    return gps["lon"] * 1e-7, gps["lat"] * 1e-7, gps["alt"] * 1e-3


def px4_lines(log):
    def data(name):
        found = [d for d in log.data_list if d.name == name and d.multi_id == 0]
        return found[0].data if found else None
    events = []
    imu = data("sensor_combined")
    for i, t in enumerate(imu["timestamp"]):
        numbers = [imu["gyro_rad[%d]" % k][i] for k in range(3)] + [imu["accelerometer_m_s2[%d]" % k][i] for k in range(3)]
        events.append((int(t), "I %d IMU %s" % (t, " ".join("%.9g" % v for v in numbers))))
    if data("vehicle_gps_position") is None:  # an old log: the magnetometer is in sensor_combined, and nothing says where it is
        last = None
        for i, t in enumerate(imu["timestamp"]):
            field = tuple(imu["magnetometer_ga[%d]" % k][i] for k in range(3))
            if field != last:
                events.append((int(t), "M %d Magnetometer %s 0.0 0.1" % (t, " ".join("%.7g" % v for v in field))))
                last = field
        return [line for _, line in sorted(events, key=lambda each: each[0])], data
    gps = data("vehicle_gps_position")
    longitude, latitude, altitude = place(gps)
    delay = int(log.initial_parameters.get("EKF2_GPS_DELAY", 110.0) * 1000)
    for i, t in enumerate(gps["timestamp"]):
        if gps["fix_type"][i] >= 3:
            events.append((int(t), "S %d GPS GLOBAL x=%.9f y=%.9f z=%.4f xSigma=%.3f ySigma=%.3f zSigma=%.3f xDot=%.4f yDot=%.4f zDot=%.4f "
                           "xDotSigma=%.3f yDotSigma=%.3f zDotSigma=%.3f" % (
                               int(t) - delay, longitude[i], latitude[i], altitude[i],
                               gps["eph"][i], gps["eph"][i], gps["epv"][i], gps["vel_e_m_s"][i], gps["vel_n_m_s"][i], -gps["vel_d_m_s"][i],
                               gps["s_variance_m_s"][i], gps["s_variance_m_s"][i], gps["s_variance_m_s"][i])))
    mag = data("vehicle_magnetometer")
    declination = math.radians(log.initial_parameters.get("EKF2_MAG_DECL", 0.0))
    for i, t in enumerate(sampled(mag)):
        field = [mag["magnetometer_ga[%d]" % k][i] for k in range(3)]
        events.append((int(t), "M %d Magnetometer %s %.6f 0.1" % (t, " ".join("%.7g" % v for v in field), declination)))
    air = data("vehicle_air_data")
    for i, t in enumerate(sampled(air)):
        events.append((int(t), "S %d Barometer GLOBAL z=%.4f zSigma=1.0" % (t, air["baro_alt_meter"][i])))
    return [line for _, line in sorted(events, key=lambda each: each[0])], data


def attitude_differences(attitude, stamps, ours, start):
    t = stamps.astype(float)
    late = t > start
    q = [attitude["q[%d]" % k] for k in range(4)]
    phi = np.arctan2(2 * (q[0] * q[1] + q[2] * q[3]), 1 - 2 * (q[1] ** 2 + q[2] ** 2))[late]
    theta = np.arcsin(np.clip(2 * (q[0] * q[2] - q[3] * q[1]), -1, 1))[late]
    psi = np.arctan2(2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2] ** 2 + q[3] ** 2))[late]
    t = t[late]
    tilt = np.hypot(at(t, ours[:, 0], ours[:, 10]) - phi, at(t, ours[:, 0], ours[:, 11]) - theta)
    return tilt, wrapped(at(t, ours[:, 0], np.unwrap(ours[:, 12])) - psi)


def px4(java, path, work):
    """Prints how far the filter is from EKF2's own answer; returns the same as pairs of metric and value, none if it cannot be judged."""
    from pyulog import ULog
    log = ULog(str(path))
    imu = log.get_dataset("sensor_combined").data["timestamp"]
    if np.median(np.diff(imu)) > SLOWEST_IMU_S * 1e6:
        print("\n**%s**: not judged, the log has an IMU reading only every %.2f s" % (path.name, np.median(np.diff(imu)) / 1e6))
        return []
    lines, data = px4_lines(log)
    has_gps = data("vehicle_gps_position") is not None
    ours, words = replay(java, "AIR", lines, work, path.stem, needs_position=has_gps)
    answer, attitude = data("vehicle_local_position"), data("vehicle_attitude")
    if not has_gps:
        start = max(ours[0, 0], attitude["timestamp"][0]) + 5e6 if len(ours) else math.inf
        if start > attitude["timestamp"][-1]:
            print("\n**%s**: not judged, shorter than 5 s after the start" % path.name)
            return []
        tilt, heading = attitude_differences(attitude, attitude["timestamp"], ours, start)
        print("\n**%s** (a real board without GPS) against EKF2's own answer, last %.0f s\n" % (path.name, (attitude["timestamp"][-1] - start) / 1e6))
        print("| roll, pitch | heading less its mean |\n| --- | --- |\n| %.2f° | %.2f° |" % (math.degrees(rms(tilt)), math.degrees(np.std(heading))))
        print("\n```\n" + words.strip() + "\n```")
        return [("roll, pitch RMS [deg]", math.degrees(rms(tilt))), ("heading less its mean [deg]", math.degrees(np.std(heading)))]
    valid = (answer["xy_valid"] == 1) & (answer["z_valid"] == 1) & (answer["xy_global"] == 1) & ~np.isnan(answer["ref_lat"])
    t = sampled(answer)[valid].astype(float)
    t0 = max(t[0], ours[0, 0]) + 5e6 if len(t) and len(ours) else math.inf  # both have settled
    use = t > t0
    t = t[use]
    if not len(t):
        print("\n**%s**: not judged, no global position of both EKF2 and the filter for more than 5 s" % path.name)
        return []
    pick = {k: answer[k][valid][use].astype(float) for k in ("x", "y", "z", "vx", "vy", "vz", "ref_lat", "ref_lon", "ref_alt", "eph")}
    ref = np.stack([pick["x"], pick["y"], pick["z"]], axis=1)
    lat, alt = (at(t, ours[:, 0], ours[:, k]) for k in (1, 3))
    lon = at(t, ours[:, 0], np.unwrap(ours[:, 2], period=360.0))
    north = np.radians(lat - pick["ref_lat"]) * 6371000.0  # PX4's map projection is a sphere's
    east = wrapped(np.radians(lon - pick["ref_lon"])) * 6371000.0 * np.cos(np.radians(pick["ref_lat"]))
    est = np.stack([north, east, pick["ref_alt"] - alt], axis=1)
    moved = np.ptp(ref, axis=0)
    horizontal = rms(np.hypot(est[:, 0] - ref[:, 0], est[:, 1] - ref[:, 1]))
    velocity = rms([np.hypot(np.hypot(at(t, ours[:, 0], ours[:, 7]) - pick["vx"], at(t, ours[:, 0], ours[:, 8]) - pick["vy"]),
                             at(t, ours[:, 0], ours[:, 9]) - pick["vz"])])
    tilt, heading = (rms(each) for each in attitude_differences(attitude, sampled(attitude), ours, t0))
    print("\n**%s** against EKF2's own answer, last %.0f s (moved %.1f m north, %.1f m east, %.1f m up)\n" % (path.name, (t[-1] - t[0]) / 1e6, *moved))
    print("| position, evo APE | horizontal | altitude | velocity | roll, pitch | heading |\n| --- | --- | --- | --- | --- | --- |")
    print("| %.2f m | %.2f m | %.2f m | %.2f m/s | %.2f° | %.2f° |" % (
        ape(t / 1e6, ref, est), horizontal, rms(est[:, 2] - ref[:, 2]), velocity, math.degrees(tilt), math.degrees(heading)))
    print("\n```\n" + words.strip() + "\n```")
    return [("horizontal RMS [m]", horizontal), ("altitude RMS [m]", rms(est[:, 2] - ref[:, 2])), ("velocity RMS [m/s]", velocity),
            ("roll, pitch RMS [deg]", math.degrees(tilt)), ("heading RMS [deg]", math.degrees(heading))]


def table(path):
    return np.array([[float(v) for v in line.split()] for line in path.read_text().splitlines() if line and not line.startswith("#")])


def mrclam_lines(folder, robot):
    landmarks = {int(r[0]): (r[1], r[2]) for r in table(folder / "Landmark_Groundtruth.dat")}
    subjects = {int(r[1]): int(r[0]) for r in table(folder / "Barcodes.dat")}
    odometry = table(folder / ("Robot%d_Odometry.dat" % robot))
    seen = table(folder / ("Robot%d_Measurement.dat" % robot))
    truth = table(folder / ("Robot%d_Groundtruth.dat" % robot))
    start = max(odometry[0, 0], truth[0, 0])
    end = min(odometry[-1, 0], truth[-1, 0])
    first = truth[np.searchsorted(truth[:, 0], start)]
    micros = lambda t: int(round(t * 1e6))  # noqa: E731
    events = [(start, 0, "S %d Start LOCAL_ENU x=%.5f y=%.5f psi=%.5f xSigma=0.05 ySigma=0.05 psiSigma=0.05" % (micros(start), *first[1:4]))]
    # Commands, held for a second and more, rather than measurements: a hundred equal ones a second are no hundred opinions.
    driven = odometry[(odometry[:, 0] >= start) & (odometry[:, 0] <= end)]
    for interval in np.split(driven, np.flatnonzero(np.diff(np.floor(driven[:, 0] / ODOMETRY_S))) + 1):
        t, v, w = interval[-1, 0], *interval[:, 1:].mean(axis=0)
        events.append((t, 1, "S %d Odometry BODY_FLU xDot=%.4f psiDot=%.4f xDotSigma=%.3f psiDotSigma=%.3f" % (
            micros(t), v, w, 0.05 + 0.3 * abs(v), 0.2 + abs(w))))
    for t, code, distance, bearing in seen:
        subject = subjects.get(int(code))
        if subject in landmarks and start <= t <= end:
            x, y = landmarks[subject]
            events.append((t, 2, "L %d Camera %.5f %.5f %.4f %.4f %.3f 0.08" % (micros(t), x, y, distance, bearing, 0.1 + 0.03 * distance)))
    return [line for _, _, line in sorted(events, key=lambda e: (e[0], e[1]))], truth, odometry, start, end


def dead_reckoning(odometry, truth, start, end, t):
    first = truth[np.searchsorted(truth[:, 0], start)]
    x, y, psi, out = first[1], first[2], first[3], []
    rows = odometry[(odometry[:, 0] >= start) & (odometry[:, 0] <= end)]
    for i in range(len(rows)):
        out.append((rows[i, 0], x, y))
        dt = rows[i + 1, 0] - rows[i, 0] if i + 1 < len(rows) else 0.0
        x, y, psi = x + dt * rows[i, 1] * math.cos(psi), y + dt * rows[i, 1] * math.sin(psi), psi + dt * rows[i, 2]
    out = np.array(out)
    return rms(np.hypot(at(t, out[:, 0], out[:, 1]) - at(t, truth[:, 0], truth[:, 1]), at(t, out[:, 0], out[:, 2]) - at(t, truth[:, 0], truth[:, 2])))


def judged(t, truth, stamp, x, y, psi, variance):
    """RMS position error [m], heading error [deg], share within 3 standard deviations [%]."""
    off = np.hypot(at(t, stamp, x) - at(t, truth[:, 0], truth[:, 1]), at(t, stamp, y) - at(t, truth[:, 0], truth[:, 2]))
    turned = wrapped(at(t, stamp, np.unwrap(psi)) - at(t, truth[:, 0], np.unwrap(truth[:, 3])))
    return rms(off), math.degrees(rms(turned)), 100 * np.mean(off < 3 * np.sqrt(at(t, stamp, variance)))


def as_objects(lines, is_known):
    """The same lines with landmarks as objects that the World Modeler recognises, or learns where it first sees them."""
    places, out = {}, []
    for line in lines:
        w = line.split()
        if w[0] == "L":
            uid = places.setdefault((w[3], w[4]), "landmark%d" % len(places))
            out.append(" ".join(["O", w[1], w[2], uid, *w[5:]]))
        else:
            out.append(line)
    first = lines[0].split()[1]
    known = ["K %s %s %s %s" % (first, uid, x, y) for (x, y), uid in places.items()]
    return (known if is_known else []) + out


def mrclam(java, folder, work):
    """Prints a table, and returns for each robot what judged() says of the filter and of the textbook filter."""
    answers = []
    print("\n**UTIAS %s**: odometry and landmarks of known place against ground truth\n" % folder.name)
    print("| robot | minutes | odometry alone | filter, evo APE | worst | drift per 5 m, evo RPE | heading | within 3 σ | "
          "textbook EKF | its heading | within 3 σ |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for robot in range(1, 6):
        lines, truth, odometry, start, end = mrclam_lines(folder, robot)
        ours, words = replay(java, "GROUND", lines, work, "%s-%d" % (folder.name, robot))
        t = truth[(truth[:, 0] > start + 1) & (truth[:, 0] < end), 0]
        x, y = at(t, truth[:, 0], truth[:, 1]), at(t, truth[:, 0], truth[:, 2])
        psi = at(t, truth[:, 0], np.unwrap(truth[:, 3]))
        stamp = ours[:, 0] / 1e6
        north, east = at(t, stamp, ours[:, 4]), at(t, stamp, ours[:, 5])
        own_psi = math.pi / 2 - at(t, stamp, np.unwrap(ours[:, 12]))
        zero = np.zeros_like(t)
        ref, est = np.stack([x, y, zero], axis=1), np.stack([east, north, zero], axis=1)
        own = judged(t, truth, stamp, ours[:, 5], ours[:, 4], math.pi / 2 - ours[:, 12], ours[:, 13] ** 2 + ours[:, 14] ** 2)
        judge = unicycle.track(lines)
        other = judged(t, truth, judge[:, 0], judge[:, 1], judge[:, 2], judge[:, 3], judge[:, 4] + judge[:, 5])
        variants = []
        for name, text in (("none", [line for line in lines if line[0] != "L"]), ("known", as_objects(lines, True)),
                           ("learnt", as_objects(lines, False))):
            track, _ = replay(java, "GROUND", text, work, "%s-%d-%s" % (folder.name, robot, name))
            variants.append(judged(t, truth, track[:, 0] / 1e6, track[:, 5], track[:, 4], math.pi / 2 - track[:, 12],
                                   track[:, 13] ** 2 + track[:, 14] ** 2))
        answers.append((own, other, *variants))
        print("| %d | %.0f | %.2f m | %.3f m | %.2f m | %.3f m | %.1f° | %.0f %% | %.3f m | %.1f° | %.0f %% |" % (
            robot, (end - start) / 60, dead_reckoning(odometry, truth, start, end, t), ape(t, ref, est),
            np.hypot(east - x, north - y).max(), rpe(t, ref, est, psi, own_psi, 5.0), own[1], own[2], *other))
    print("\n```\n" + words.strip() + "\n```")
    return answers


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--java", required=True)
    parser.add_argument("--ulog", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--mrclam", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as directory:
        work = pathlib.Path(directory)
        for path in arguments.ulog:
            px4(arguments.java, path, work)
        if arguments.mrclam:
            for folder in sorted(arguments.mrclam.glob("MRCLAM_Dataset[67]")):
                mrclam(arguments.java, folder, work)


if __name__ == "__main__":
    main()
