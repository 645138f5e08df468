"""A program that drives a vehicle through an IOIO board on the network, with nothing but Python's own library.

Usage: ioio_client.py HOST PORT SECONDS [CA_FILE USER PASSWORD_FILE]

Written from the IOIO's protocol (docs/drivers/ioio-protocol.md). Reads NMEA from the GPS at pins 6 and 7, drives both
motors at pins 10 and 11 forward for SECONDS, stops, and prints one line of JSON: the board, the first and the last
position in degrees, and the distance between them in metres. It stays connected until its standard input ends; each
line "drive" on it sends the pulses again.
"""

import json
import math
import select
import socket
import ssl
import struct
import sys
import time

ESTABLISH, SOFT_CLOSE = 0x00, 0x1D
CHECK_INTERFACE, SET_DIGITAL_OUT, SET_PWM, PWM_DUTY, PWM_PERIOD = 0x02, 0x03, 0x08, 0x09, 0x0A
UART_CONFIG, UART_DATA, SET_UART = 0x0D, 0x0E, 0x0F
ENABLE = 0x80
SCALE_8 = 3  # the clock of 16 MHz by 8
CLOCKS_PER_US = 2
PERIOD_US = 20_000
METRES_PER_DEGREE = 111_195.0
WAIT_FOR_FIX_S = 20
LENGTHS = {0x01: 0, 0x02: 1, 0x04: 1, 0x0D: 1, 0x0F: 2, 0x1D: 0, 0x23: 0}  # of the board's messages that are fixed


class Board:
    """One connection to a board."""

    def __init__(self, host, port, secured):
        self.link = socket.create_connection((host, port), timeout=20)
        if secured:
            authority, user, password_file = secured
            self.link = ssl.create_default_context(cafile=authority).wrap_socket(self.link, server_hostname=host)
            with open(password_file, encoding="utf-8") as file:
                password = file.readline().rstrip("\n")
            self.link.sendall(f"LOGIN {user} {password}\n".encode())
            answer = b""
            while not answer.endswith(b"\n"):
                answer += self.bytes(1)
            if answer != b"OK\n":
                raise ConnectionError(answer.decode().strip())
        greeting = self.bytes(29)
        if greeting[0] != ESTABLISH or greeting[1:5] != b"IOIO":
            raise ConnectionError(f"no IOIO: {greeting!r}")
        self.name = greeting[5:].decode()
        self.send(CHECK_INTERFACE, b"IOIO0005")
        if self.message() != (CHECK_INTERFACE, b"\x01"):
            raise ConnectionError("the board does not know the protocol")
        self.text = b""

    def bytes(self, count):
        """Reads exactly this number of bytes from the board."""
        got = b""
        while len(got) < count:
            piece = self.link.recv(count - len(got))
            if not piece:
                raise ConnectionError("the board ended the connection")
            got += piece
        return got

    def send(self, kind, arguments=b""):
        self.link.sendall(bytes([kind]) + arguments)

    def message(self):
        """The board's next message: its type and what follows."""
        kind = self.bytes(1)[0]
        if kind == UART_DATA:
            head = self.bytes(1)[0]
            return kind, self.bytes((head & 0x3F) + 1)
        if kind not in LENGTHS:
            raise ConnectionError(f"unexpected message {kind:#x}")
        return kind, self.bytes(LENGTHS[kind])

    def open_servo(self, module, pin):
        self.send(SET_DIGITAL_OUT, bytes([pin << 2]))
        self.send(SET_PWM, bytes([pin, module | ENABLE]))
        clocks = PERIOD_US * CLOCKS_PER_US - 1
        self.send(PWM_PERIOD, struct.pack("<BH", SCALE_8 & 1 | module << 1 | SCALE_8 >> 1 << 7, clocks))

    def pulse(self, module, micros):
        self.send(PWM_DUTY, struct.pack("<BH", module << 2, micros * CLOCKS_PER_US - 1))

    def open_uart(self, number, receive, transmit, baud):
        rate = round(4_000_000 / baud) - 1  # bit 3: the fast clock
        self.send(UART_CONFIG, struct.pack("<BH", number << 6 | 0x08, rate))
        self.send(SET_UART, bytes([transmit, number | 0x40 | ENABLE]))
        self.send(SET_UART, bytes([receive, number | ENABLE]))

    def sentences(self, until):
        """Sentences from the GPS up to a time."""
        while time.monotonic() < until:
            if not (isinstance(self.link, ssl.SSLSocket) and self.link.pending()):
                if not select.select([self.link], [], [], max(0.0, until - time.monotonic()))[0]:
                    return
            kind, content = self.message()
            self.text += content if kind == UART_DATA else b""
            *lines, self.text = self.text.split(b"\r\n")
            yield from lines


def place(sentence):
    """Latitude and longitude in degrees of a GGA sentence with a fix; None of any other."""
    fields = sentence.decode("ascii", "replace").split(",")
    if not fields[0].endswith("GGA") or len(fields) < 7 or fields[6] in ("", "0"):
        return None
    latitude = int(fields[2][:2]) + float(fields[2][2:]) / 60
    longitude = int(fields[4][:3]) + float(fields[4][3:]) / 60
    return latitude * (1 if fields[3] == "N" else -1), longitude * (1 if fields[5] == "E" else -1)


def metres(one, other):
    north = (other[0] - one[0]) * METRES_PER_DEGREE
    east = (other[1] - one[1]) * METRES_PER_DEGREE * math.cos(math.radians(one[0]))
    return math.hypot(north, east)


def drive(board, seconds):
    """Drives forward once the GPS has a fix, or says nothing for a time; the places seen."""
    places = []
    give_up = time.monotonic() + WAIT_FOR_FIX_S
    while not places and time.monotonic() < give_up:
        places += filter(None, map(place, board.sentences(time.monotonic() + 0.5)))
        for module in (0, 1):
            board.pulse(module, 1500)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for module in (0, 1):
            board.pulse(module, 1800)
        places += filter(None, map(place, board.sentences(min(end, time.monotonic() + 0.2))))
    return places


def main(host, port, seconds, *secured):
    board = Board(host, int(port), secured)
    board.open_uart(0, 6, 7, 9600)
    for module, pin in enumerate((10, 11)):
        board.open_servo(module, pin)
    places = drive(board, float(seconds))
    seen = {"first": places[0], "last": places[-1], "metres": metres(places[0], places[-1])} if places else {}
    print(json.dumps({"board": board.name, **seen}), flush=True)
    for line in sys.stdin:  # keeps driving while the test wants it to
        if line.strip() == "drive":
            for module in (0, 1):
                board.pulse(module, 1800)
    for module in (0, 1):
        board.pulse(module, 1500)
    board.send(SOFT_CLOSE)
    while board.link.recv(4096):
        pass  # until the board has closed: unread bytes would break the connection


if __name__ == "__main__":
    main(*sys.argv[1:])
