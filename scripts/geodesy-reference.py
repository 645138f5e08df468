#!/usr/bin/env python3
"""Makes the reference values that u2sa-messages' frames and conversions are tested against, with PROJ (pyproj).

    pip install pyproj && python3 scripts/geodesy-reference.py

Independent of the Java code: UTM, ECEF, topocentric axes and geodesics come from PROJ; attitudes are composed here as
quaternions, where the Java code uses matrices. Writes CSV files to u2sa-messages/src/test/resources/org/u2sa/messages/frame/.
"""
import csv
import math
import pathlib
import random

import pyproj

OUT = pathlib.Path(__file__).resolve().parent.parent / "u2sa-messages/src/test/resources/org/u2sa/messages/frame"
SEED = 20141  # the files are the same each time
CART = pyproj.Transformer.from_pipeline(
    "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart +ellps=WGS84")


def write(name, columns, rows):
    path = OUT / name
    with path.open("w", newline="", encoding="utf-8") as file:
        file.write(f"# made by scripts/geodesy-reference.py, pyproj {pyproj.__version__}, PROJ {pyproj.proj_version_str}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(columns)
        table.writerows([[repr(v) if isinstance(v, float) else v for v in row] for row in rows])
    print(path, len(rows), "rows")


def topocentric(lon, lat, alt):
    """ECEF [m] to east, north, up [m] at a place."""
    return pyproj.Transformer.from_pipeline(
        f"+proj=topocentric +ellps=WGS84 +lon_0={lon!r} +lat_0={lat!r} +h_0={alt!r}").transform


def axes(lon, lat, alt):
    """Rows: east, north, up in ECEF. PROJ's topocentric step is linear, so differences are exact."""
    to_enu = topocentric(lon, lat, alt)
    base = to_enu(0.0, 0.0, 0.0)
    columns = []
    for axis in range(3):
        far = [0.0, 0.0, 0.0]
        far[axis] = 1e7
        columns.append([(a - b) / 1e7 for a, b in zip(to_enu(*far), base)])
    return [[columns[c][r] for c in range(3)] for r in range(3)]


def apply(matrix, v):
    return [sum(matrix[r][c] * v[c] for c in range(3)) for r in range(3)]


def transposed(m):
    return [list(row) for row in zip(*m)]


def quaternion(angle, axis):
    q = [math.cos(angle / 2), 0.0, 0.0, 0.0]
    q[axis + 1] = math.sin(angle / 2)
    return q


def product(a, b):
    w, x, y, z = a
    s, t, u, v = b
    return [w * s - x * t - y * u - z * v, w * t + x * s + y * v - z * u,
            w * u - x * v + y * s + z * t, w * v + x * u - y * t + z * s]


def turned(q, v):
    conjugate = [q[0], -q[1], -q[2], -q[3]]
    return product(product(q, [0.0] + list(v)), conjugate)[1:]


def attitude(phi, theta, psi):
    """FRD to NED: yaw, pitch, roll."""
    return product(product(quaternion(psi, 2), quaternion(theta, 1)), quaternion(phi, 0))


def angles(forward, right):
    """Roll, pitch, heading of FRD axes whose forward and right vectors are given in NED."""
    psi = math.atan2(forward[1], forward[0]) % (2 * math.pi)
    theta = math.asin(-forward[2])
    # right, seen from the axes after yaw and pitch
    y1 = [-math.sin(psi), math.cos(psi), 0.0]
    z1 = [math.sin(theta) * math.cos(psi), math.sin(theta) * math.sin(psi), math.cos(theta)]
    phi = math.atan2(sum(a * b for a, b in zip(right, z1)), sum(a * b for a, b in zip(right, y1)))
    return phi, theta, psi


def ned(v):
    return [v[1], v[0], -v[2]]


def utm(rng):
    rows = []
    for _ in range(120):
        zone = rng.randint(1, 60)
        north = rng.random() < 0.5
        lon = zone * 6 - 183 + rng.uniform(-3.2, 3.2)
        lat = rng.uniform(0.0, 83.9) * (1 if north else -1)
        lon = (lon + 180) % 360 - 180
        projection = pyproj.Proj(proj="utm", zone=zone, south=not north, ellps="WGS84")
        east, nord = projection(lon, lat)
        factors = projection.get_factors(lon, lat)
        rows.append([zone, "N" if north else "S", lon, lat, east, nord,
                     factors.meridian_convergence, factors.meridional_scale])
    write("utm.csv", ["zone", "hemisphere", "lonDeg", "latDeg", "eastingM", "northingM", "convergenceDeg", "scale"], rows)


def local(rng):
    rows = []
    for _ in range(120):
        lon, lat, alt = rng.uniform(-180, 180), rng.uniform(-89.5, 89.5), rng.uniform(-4000, 12000)
        reach = rng.choice([0.001, 0.1, 1.0, 20.0])
        lon2 = (lon + rng.uniform(-reach, reach) + 180) % 360 - 180
        lat2 = max(-89.9, min(89.9, lat + rng.uniform(-reach, reach)))
        alt2 = rng.uniform(-4000, 12000)
        enu = topocentric(lon, lat, alt)(*CART.transform(lon2, lat2, alt2))
        rows.append([lon, lat, alt, lon2, lat2, alt2, *enu])
    write("enu.csv", ["lonDeg", "latDeg", "altM", "lon2Deg", "lat2Deg", "alt2M", "eastM", "northM", "upM"], rows)


def geodesics(rng):
    geod = pyproj.Geod(ellps="WGS84")
    rows = []
    for _ in range(60):
        lon, lat = rng.uniform(-180, 180), rng.uniform(-89, 89)
        azimuth, distance = rng.uniform(0, 360), rng.choice([1.0, 1e3, 1e5, 5e6]) * rng.random()
        lon2, lat2, _ = geod.fwd(lon, lat, azimuth, distance)
        rows.append([lon, lat, azimuth, distance, lon2, lat2])
    write("geodesic.csv", ["lonDeg", "latDeg", "azimuthDeg", "distanceM", "lon2Deg", "lat2Deg"], rows)


def states(rng):
    """A vehicle in GLOBAL, and what it is in LOCAL_NED and LOCAL_ENU of an origin."""
    rows = []
    for _ in range(60):
        olon, olat, oalt = rng.uniform(-180, 180), rng.uniform(-75, 75), rng.uniform(0, 3000)
        reach = rng.choice([0.01, 0.3, 3.0])
        lon = (olon + rng.uniform(-reach, reach) + 180) % 360 - 180
        lat, alt = olat + rng.uniform(-reach, reach), rng.uniform(0, 3000)
        velocity = [rng.uniform(-80, 80) for _ in range(3)]
        euler = rng.uniform(-3, 3), rng.uniform(-1.4, 1.4), rng.uniform(0, 2 * math.pi)
        here, there = axes(lon, lat, alt), axes(olon, olat, oalt)

        def carried(enu_vector):
            return apply(there, apply(transposed(here), enu_vector))

        position = topocentric(olon, olat, oalt)(*CART.transform(lon, lat, alt))
        q = attitude(*euler)
        body = [ned(carried(ned(turned(q, v)))) for v in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]  # FRD axes in the origin's NED
        ned_angles = angles(body[0], body[1])
        # FLU axes in ENU, their right-handed yaw, pitch, roll
        forward, left = ned(body[0]), [-c for c in ned(body[1])]
        yaw = math.atan2(forward[1], forward[0]) % (2 * math.pi)
        pitch = -math.asin(forward[2])
        level_left = [-math.sin(yaw), math.cos(yaw), 0.0]
        up = [math.sin(pitch) * math.cos(yaw), math.sin(pitch) * math.sin(yaw), math.cos(pitch)]
        roll = math.atan2(sum(a * b for a, b in zip(left, up)), sum(a * b for a, b in zip(left, level_left)))
        rows.append([olon, olat, oalt, lon, lat, alt, *velocity, *euler,
                     *ned(position), *ned(carried(velocity)), *ned_angles, roll, pitch, yaw])
    write("state.csv", ["originLonDeg", "originLatDeg", "originAltM", "lonDeg", "latDeg", "altM", "eastMps", "northMps", "upMps",
                        "phi", "theta", "psi", "nM", "eM", "dM", "vnMps", "veMps", "vdMps", "nedPhi", "nedTheta", "nedPsi",
                        "enuPhi", "enuTheta", "enuPsi"], rows)


def body_points(rng):
    """A point on the earth as a vehicle sees it along its FRD axes."""
    rows = []
    for _ in range(60):
        lon, lat, alt = rng.uniform(-180, 180), rng.uniform(-80, 80), rng.uniform(0, 3000)
        reach = rng.choice([0.0005, 0.02])
        plon = (lon + rng.uniform(-reach, reach) + 180) % 360 - 180
        plat, palt = lat + rng.uniform(-reach, reach), rng.uniform(0, 3000)
        euler = rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
        q = attitude(*euler)
        frd = turned([q[0], -q[1], -q[2], -q[3]], ned(topocentric(lon, lat, alt)(*CART.transform(plon, plat, palt))))
        rows.append([lon, lat, alt, *euler, plon, plat, palt, *frd])
    write("body.csv", ["lonDeg", "latDeg", "altM", "phi", "theta", "psi", "pointLonDeg", "pointLatDeg", "pointAltM",
                       "forwardM", "rightM", "downM"], rows)


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    for number, make in enumerate([utm, local, geodesics, states, body_points]):
        make(random.Random(SEED + number))


if __name__ == "__main__":
    main()
