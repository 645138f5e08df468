"""What pynmea2 understands of a capture, for NmeaCaptureTest: one line for each moment that the receiver names.

pip install pynmea2==1.19.0; python3 nmea_golden.py landing.nmea > landing.csv
"""
import sys

import pynmea2

POSITIONS = ("RMC", "GGA")


def moments(path):
    """The sentences with a position, those of one time together."""
    together = {}
    time = None
    with open(path, encoding="ascii", newline="") as capture:
        for line in capture:
            sentence = pynmea2.parse(line.strip(), check=True)
            kind = sentence.sentence_type
            if kind not in POSITIONS:
                continue
            if together and (sentence.timestamp != time or kind in together):
                yield together
                together = {}
            time = sentence.timestamp
            together[kind] = sentence
    if together:
        yield together


print("valid,latitude deg,longitude deg,altitude m,speed kn,course deg,satellites")
for moment in moments(sys.argv[1]):
    rmc, gga = moment.get("RMC"), moment.get("GGA")
    valid = rmc.status == "A" and gga.gps_qual > 0
    if valid:
        course = "" if rmc.true_course is None else f"{rmc.true_course}"
        print(
            f"true,{gga.latitude:.9f},{gga.longitude:.9f},{gga.altitude},{rmc.spd_over_grnd},{course},{int(gga.num_sats)}"
        )
    else:
        print("false,,,,,,")
