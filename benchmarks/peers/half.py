"""One half of a peer's way, as a process: half.py listen|send WAY PORT BYTES PROGRESS. Obeys lines of standard input, and answers each with a line of JSON.
The first line says that it has started. An answer {"error": why} says what failed.

    begin                       the listener forgets what came
    report                      the listener says how many came, the times that they took [ns], and its processor time [s]
    probe                       the sender sends until something arrives
    send HZ SECONDS WINDOW      the sender sends; HZ 0: as many as arrive, with WINDOW on the way at most
"""
import json
import mmap
import os
import struct
import sys
import time

import ways

LOST_AFTER_S = 3.0
SENT_AT_ONCE = 16
PERCENTILES = (50.0, 99.0, 99.9)


class Listening:
    def __init__(self, make, progress):
        self._progress = progress
        self._took = []
        self._cpu = 0.0
        self.way = make(self._arrived)  # kept: some close with their last reference

    def _arrived(self, contents):
        self._took.append(time.monotonic_ns() - struct.unpack_from(">q", contents)[0])
        struct.pack_into("<q", self._progress, 0, len(self._took))

    def begin(self):
        self._took = []
        struct.pack_into("<q", self._progress, 0, 0)
        self._cpu = time.process_time()
        return {}

    def report(self):
        took = sorted(self._took)
        return {"arrived": len(took), "cpu_s": time.process_time() - self._cpu,
                "ns": [took[min(len(took) - 1, int(len(took) * p / 100))] if took else None for p in PERCENTILES]}


class Sending:
    def __init__(self, make, size, progress):
        self._filling = bytes(size - 8)
        self._progress = progress
        self.way = make(None)  # kept: some close with their last reference
        self._send = self.way.send

    def _one(self):
        self._send(struct.pack(">q", time.monotonic_ns()) + self._filling)

    def _arrived(self):
        return struct.unpack_from("<q", self._progress, 0)[0]

    def probe(self):
        end = time.monotonic() + 20.0
        while self._arrived() == 0:
            if time.monotonic() > end:
                return {"error": "nothing arrived within 20 s"}
            self._one()
            time.sleep(0.05)
        time.sleep(0.5)
        return {}

    def send(self, hz, seconds, window):
        cpu = time.process_time()
        began = time.monotonic()
        sent = self._paced(began, float(hz), float(seconds)) if float(hz) else self._flat_out(began, float(seconds), int(window))
        self._settle(sent)
        return {"sent": sent, "took_s": time.monotonic() - began, "cpu_s": time.process_time() - cpu}

    def _paced(self, began, hz, seconds):
        count = int(hz * seconds)
        for i in range(count):
            wait = began + i / hz - time.monotonic()
            if wait > 0:
                time.sleep(wait)
            self._one()
        return count

    def _flat_out(self, began, seconds, window):
        sent = 0
        while time.monotonic() < began + seconds:
            if not self._settle(sent - window + SENT_AT_ONCE):
                return sent
            for _ in range(SENT_AT_ONCE):
                self._one()
            sent += SENT_AT_ONCE
        return sent

    def _settle(self, least):
        """Waits until that many have arrived; false if none has for a while."""
        seen, since = self._arrived(), time.monotonic()
        while self._arrived() < least:
            time.sleep(1e-5)
            if self._arrived() != seen:
                seen, since = self._arrived(), time.monotonic()
            elif time.monotonic() - since > LOST_AFTER_S:
                return False
        return True


def main():
    role, way, port, size, file = sys.argv[1:]
    with open(file, "r+b") as opened:
        progress = mmap.mmap(opened.fileno(), 8)

    def make(arrived):
        return ways.ALL[way](int(port), int(size), arrived)

    try:
        half = Listening(make, progress) if role == "listen" else Sending(make, int(size), progress)
    except ImportError as e:
        print(json.dumps({"error": str(e)}), flush=True)
        return
    print("{}", flush=True)
    try:
        for line in sys.stdin:
            order, *words = line.split()
            print(json.dumps(getattr(half, order)(*words)), flush=True)
    finally:
        getattr(half.way, "close", lambda: None)()
    os._exit(0)  # some peers' threads do not end by themselves


if __name__ == "__main__":
    main()
