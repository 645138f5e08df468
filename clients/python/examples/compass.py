#!/usr/bin/env python3
"""A compass: reads NMEA 0183 headings (HDT, HDM, HDG) from a serial device, a file or standard input, and tells the
State Estimator. Out: sensed-state, StateInformation with psi [rad, clockwise from true north] and psiSigma [rad].

    python3 examples/compass.py --device /dev/ttyUSB0 --system cessna --broker localhost:1883
    python3 examples/compass.py --simulate        # turns once a minute
"""
from __future__ import annotations

import argparse
import functools
import logging
import math
import operator
import pathlib
import sys
import threading
import time
from typing import Any, Iterable, List, Optional, Tuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from u2sa import Broker, CannotConnect, Message, Service, Variable  # noqa: E402

TURN = 2.0 * math.pi
LONGEST_LINE = 1_024  # characters; a device that sends no line ends must not fill the memory
VARIABLES = (
    Variable("DECLINATION", 0.0, "rad", -math.pi, math.pi,
             description="Angle from true to magnetic north, east positive; added to magnetic headings."),
    Variable("HEADING SIGMA", 0.02, "rad", 0.0, math.pi, description="Standard deviation of the heading."),
    Variable("STALE AFTER", 1.0, "s", 0.01, 60.0, description="Age at which a heading is no longer told."),
)


def heading(sentence: str) -> Optional[Tuple[float, bool]]:
    """Heading [rad, clockwise] of an NMEA sentence and whether it is of true north; None if it tells none or is broken."""
    body, star, checksum = sentence.strip().lstrip("$").partition("*")
    try:
        if star and int(checksum, 16) != functools.reduce(operator.xor, body.encode("ascii"), 0):
            return None
        fields = body.split(",")
        if fields[0][2:] not in ("HDT", "HDM", "HDG"):
            return None
        degrees = float(fields[1])
    except (ValueError, IndexError):
        return None
    if not 0.0 <= degrees <= 360.0:
        return None
    return math.radians(degrees), fields[0].endswith("HDT")


class Compass(Service):
    """Tells the newest heading at a steady rate."""

    role = "PROPRIOCEPTIVE_SENSOR"
    rate_hz = 10.0
    version = "0.1.0"

    def __init__(self, sentences: Optional[Iterable[str]], **context: Any) -> None:
        super().__init__("Compass", variables=VARIABLES, **context)
        self._sentences = sentences
        # Measured at [s], heading [rad], of true north; replaced as a whole by the device's thread.
        self._newest: Optional[Tuple[float, float, bool]] = None
        self.register_publisher("sensed-state", "StateInformation")

    def begin(self) -> None:
        if self._sentences is not None:
            threading.Thread(target=self._read, name="Compass device", daemon=True).start()

    def _read(self) -> None:
        for sentence in self._sentences or ():
            read = heading(sentence)
            if read is not None:
                self._newest = (time.time(), *read)

    def step(self, now_s: float) -> None:
        newest = self._newest if self._sentences is not None else (now_s, TURN * (now_s % 60.0) / 60.0, False)
        if newest is None or now_s - newest[0] > self.configuration.number("STALE AFTER"):
            return
        measured_s, psi, is_true = newest
        if not is_true:
            psi += self.configuration.number("DECLINATION")
        self.publish("sensed-state", Message(
            "StateInformation", timestamp=int(measured_s * 1e6), sensorName=self.name, psi=psi % TURN,
            psiSigma=self.configuration.number("HEADING SIGMA")))


def main(arguments: List[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--device", help="serial device or file with NMEA sentences; - is standard input")
    source.add_argument("--simulate", action="store_true", help="turn once a minute")
    parser.add_argument("--system", default="cessna", help="system ID (default: %(default)s)")
    parser.add_argument("--broker", default="localhost:1883", metavar="HOST[:PORT]")
    parser.add_argument("--user")
    parser.add_argument("--password-file", type=pathlib.Path)
    parser.add_argument("--ca", help="certificate of the authority that signed the broker's; makes the connection TLS")
    parser.add_argument("--configuration", type=pathlib.Path, help="XML file with the service's variables")
    given = parser.parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s | %(levelname)s | %(name)s | %(message)s")
    host, _, port = given.broker.partition(":")
    try:
        password = given.password_file.read_text(encoding="utf-8").strip() if given.password_file else None
        device = None
        if given.device is not None:
            device = sys.stdin if given.device == "-" else open(given.device, encoding="ascii", errors="replace")
        sentences = None if device is None else iter(functools.partial(device.readline, LONGEST_LINE), "")
        compass = Compass(sentences, system_id=given.system, file=given.configuration,
                          broker=Broker(host, int(port or 1883), given.user, password, given.ca))
        return compass.run()
    except (CannotConnect, OSError, ValueError) as e:
        print(e, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
