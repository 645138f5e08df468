#!/usr/bin/env python3
"""Judges with pynmea2 and pyubx2 the bytes that the simulated GPS and compass send (GoldenBytesTest writes and holds them): each
message must be understood, its checksum right, and its numbers those that went in. Exit code 1: something differs.

    pip install pynmea2==1.19.0 pyubx2==1.4.0
    python3 scripts/sensors/check.py
"""
import datetime
import math
import pathlib
import sys

import pynmea2
import pyubx2

FILES = pathlib.Path(__file__).resolve().parents[2] / "u2sa-sim/src/test/resources/sensor"
BEGIN = datetime.datetime(2026, 11, 21, 23, 59, 58, 500000)
GPS_EPOCH = datetime.datetime(1980, 1, 6)
LEAP = datetime.timedelta(seconds=18)
KNOT = 1852 / 3600

# time, valid, latitude, longitude, altitude, east, north, up, horizontal and vertical sigma, velocity sigma, satellites, quality:
# as GoldenBytesTest has them
SAMPLES = [
    (0.0, True, 37.2283843, -80.4234167, 633.251, 0.5, 1.25, -0.02, 0.02, 0.03, 0.03, 16, 4),
    (0.7, True, -33.999999999, 151.2099, 12.0, -0.25, -1.0, 0.1, 0.02, 0.03, 0.03, 16, 4),
    (1.4, True, 0.0, 179.9999999999, -3.5, -0.0001, 1.5, 0.0, 0.02, 0.03, 0.03, 16, 4),
    (1.5, True, 89.12345678, -0.0000001, 0.0, 0.0, 0.0, 0.0, 0.02, 0.03, 0.03, 16, 4),
    (1.6, False, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
    (99.123, True, 51.5, 7.25, 100, 3, -4, 0, 3.04, 4.56, 0.15, 9, 1),
]
HEADINGS = (0.0, 1.0, math.pi, 6.2831, 6.28)
wrong = []


def near(what, seen, wanted, by):
    if seen is None or seen == "" or abs(float(seen) - wanted) > by:
        wrong.append(f"{what}: {seen!r}, expected {wanted}")


def same(what, seen, wanted):
    if seen != wanted:
        wrong.append(f"{what}: {seen!r}, expected {wanted!r}")


def turn(what, seen, wanted, by):
    near(what, (float(seen) - wanted + 180) % 360 - 180, 0, by)
    if not 0 <= float(seen) < 360:
        wrong.append(f"{what}: {seen} is outside 0..360")


def nmea(name, degrees):
    lines = (FILES / name).read_bytes().decode("ascii").split("\r\n")
    same(f"{name}: end", lines.pop(), "")
    for number, line in enumerate(lines):
        message = pynmea2.parse(line, check=True)
        t, valid, lat, lon, alt, east, north, _, sigma, sigma_up, _, satellites, quality = SAMPLES[number // 4]
        what = f"{name} {line}"
        speed, course = math.hypot(east, north), math.degrees(math.atan2(east, north))
        time = BEGIN + datetime.timedelta(seconds=t)
        same(what, message.sentence_type, ("GGA", "RMC", "VTG", "GST")[number % 4])
        if message.sentence_type != "VTG":
            seen = datetime.datetime.combine(time.date(), message.timestamp.replace(tzinfo=None))
            near(f"{what}: time", (seen - time).total_seconds(), 0, 0.0051)
        if message.sentence_type in ("GGA", "RMC") and valid:
            near(f"{what}: latitude", message.latitude, lat, degrees)
            near(f"{what}: longitude", message.longitude, lon, degrees)
        if message.sentence_type == "GGA":
            same(f"{what}: quality", int(message.gps_qual), quality)
            if valid:
                near(f"{what}: altitude", message.altitude, alt, 0.0006)
                same(f"{what}: satellites", int(message.num_sats), min(12, satellites))
        elif message.sentence_type == "RMC":
            same(f"{what}: date", message.datestamp, time.date())
            same(f"{what}: valid", message.is_valid, valid)
            if valid:
                near(f"{what}: speed", float(message.spd_over_grnd) * KNOT, speed, 0.0006)
                turn(f"{what}: course", message.true_course, course, 0.006)
        elif message.sentence_type == "VTG" and valid:
            near(f"{what}: speed", float(message.spd_over_grnd_kts) * KNOT, speed, 0.0006)
            near(f"{what}: speed", float(message.spd_over_grnd_kmph) / 3.6, speed, 0.0006)
            turn(f"{what}: course", message.true_track, course, 0.006)
        elif message.sentence_type == "GST" and valid:
            near(f"{what}: latitude's sigma", message.std_dev_latitude, sigma, 0.0006)
            near(f"{what}: longitude's sigma", message.std_dev_longitude, sigma, 0.0006)
            near(f"{what}: altitude's sigma", message.std_dev_altitude, sigma_up, 0.0006)
    return len(lines)


def ubx(name):
    count = 0
    with open(FILES / name, "rb") as stream:
        for _, message in pyubx2.UBXReader(stream, protfilter=2, quitonerror=2, validate=1):
            t, valid, lat, lon, alt, east, north, up, sigma, sigma_up, sigma_v, satellites, _ = SAMPLES[count // 5]
            what = f"{name} {message.identity} at {t} s"
            same(what, message.identity, ("NAV-POSLLH", "NAV-STATUS", "NAV-SOL", "NAV-VELNED", "NAV-PVT")[count % 5])
            tow = (BEGIN + datetime.timedelta(seconds=t) - GPS_EPOCH + LEAP).total_seconds() % (7 * 86400)
            itow = message.iTOW if isinstance(message.iTOW, int) else None
            near(f"{what}: time of week", itow, round(tow * 1000), 0)
            if message.identity in ("NAV-POSLLH", "NAV-PVT") and valid:
                near(f"{what}: latitude", message.lat, lat, 6e-8)
                near(f"{what}: longitude", message.lon, lon, 6e-8)
                near(f"{what}: altitude", message.hMSL, alt * 1000, 0.51)
                near(f"{what}: accuracy", message.hAcc, sigma * 1000 * math.sqrt(2), 0.51)
                near(f"{what}: vertical accuracy", message.vAcc, sigma_up * 1000, 0.51)
            if message.identity == "NAV-STATUS":
                same(f"{what}: fix", message.gpsFix, 3 if valid else 0)
                same(f"{what}: fix OK", message.gpsFixOk, 1 if valid else 0)
            if message.identity == "NAV-SOL":
                same(f"{what}: fix", message.gpsFix, 3 if valid else 0)
                same(f"{what}: satellites", message.numSV, satellites)
                same(f"{what}: week", message.week, (BEGIN + datetime.timedelta(seconds=t) - GPS_EPOCH + LEAP).days // 7)
                if valid:
                    place = pyubx2.ecef2llh(message.ecefX / 100, message.ecefY / 100, message.ecefZ / 100)
                    near(f"{what}: latitude", place[0], lat, 1e-7)
                    near(f"{what}: longitude", (place[1] - lon + 180) % 360 - 180, 0, 1e-7 / math.cos(math.radians(lat)))
                    near(f"{what}: altitude", place[2], alt, 0.01)
                    speed = math.hypot(message.ecefVX, message.ecefVY, message.ecefVZ)
                    near(f"{what}: speed", speed, 100 * math.hypot(east, north, up), 1.0)
                    out = [message.ecefX, message.ecefY, message.ecefZ]
                    along = sum(a * b for a, b in zip(out, (message.ecefVX, message.ecefVY, message.ecefVZ))) / math.hypot(*out)
                    near(f"{what}: up", along, 100 * up, 1.6)  # seen from the earth's middle
            if message.identity == "NAV-VELNED" and valid:
                near(f"{what}: north", message.velN, north * 100, 0.51)
                near(f"{what}: east", message.velE, east * 100, 0.51)
                near(f"{what}: down", message.velD, -up * 100, 0.51)
            if message.identity == "NAV-PVT":
                time = BEGIN + datetime.timedelta(seconds=t)
                seen = datetime.datetime(message.year, message.month, message.day, message.hour, message.min, message.second)
                near(f"{what}: date", (seen - time).total_seconds() + message.nano * 1e-9, 0, 0.0006)
                same(f"{what}: fix OK", message.gnssFixOk, 1 if valid else 0)
                same(f"{what}: satellites", message.numSV, satellites)
                if valid:
                    near(f"{what}: north", message.velN, north * 1000, 0.51)
                    near(f"{what}: east", message.velE, east * 1000, 0.51)
                    near(f"{what}: down", message.velD, -up * 1000, 0.51)
                    near(f"{what}: velocity accuracy", message.sAcc, sigma_v * 1000, 0.51)
            count += 1
    return count


def compass(name):
    lines = (FILES / name).read_bytes().decode("ascii").split("\r\n")[:-1]
    for number, line in enumerate(lines):
        message = pynmea2.parse(line, check=True)
        same(line, message.sentence_type, ("HDT", "HDM", "HDG")[number % 3])
        turn(line, message.heading, math.degrees(HEADINGS[number // 3]), 0.051)
        if message.sentence_type == "HDG":
            near(f"{line}: declination", message.variation, math.degrees(0.15), 0.051)
            same(f"{line}: side", message.var_dir, "W")
    return len(lines)


counts = {
    "gps.nmea": nmea("gps.nmea", 0.5e-5 / 60 + 1e-12),
    "gps-precise.nmea": nmea("gps-precise.nmea", 0.5e-7 / 60 + 1e-12),
    "gps.ubx": ubx("gps.ubx"),
    "compass.nmea": compass("compass.nmea"),
}
for problem in wrong:
    print("differs:", problem)
for file, count in counts.items():
    print(f"{file}: {count} messages understood")
for file, wanted in (("gps.nmea", 24), ("gps-precise.nmea", 24), ("gps.ubx", 30), ("compass.nmea", 15)):
    if counts[file] != wanted:
        sys.exit(f"{file}: expected {wanted} messages")
sys.exit(1 if wrong else 0)
