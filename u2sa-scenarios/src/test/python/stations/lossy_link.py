"""A bad radio link for UDP: delays and loses the datagrams of both directions.

    python3 lossy_link.py BRIDGE STATION [ROUND_TRIP_MS JITTER_MS LOSS_PERCENT]

The bridge sends to port BRIDGE of this host, the station listens on port STATION. Half of round trip and jitter count each way.
"""
import heapq
import random
import select
import socket
import sys
import time

HOST = "127.0.0.1"


def main():
    bridge_port, station_port = int(sys.argv[1]), int(sys.argv[2])
    delay, jitter, loss = (float(each) for each in (sys.argv[3:] or ("200", "40", "5")))
    dice = random.Random(1)
    bridge = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    bridge.bind((HOST, bridge_port))
    station = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    station.bind((HOST, 0))
    bridge_at = None
    waiting = []  # when due, number, to the station, datagram
    number = 0
    print("ready", flush=True)
    while True:
        timeout = max(0.0, waiting[0][0] - time.monotonic()) if waiting else 0.1
        for source in select.select([bridge, station], [], [], timeout)[0]:
            try:
                datagram, sender = source.recvfrom(65536)
            except ConnectionError:
                continue  # the other side does not listen yet
            if source is bridge:
                bridge_at = sender
            if dice.random() * 100.0 >= loss:
                number += 1
                late = (delay + dice.uniform(-jitter, jitter)) / 2000.0
                heapq.heappush(waiting, (time.monotonic() + late, number, source is bridge, datagram))
        while waiting and waiting[0][0] <= time.monotonic():
            _, _, to_station, datagram = heapq.heappop(waiting)
            if to_station:
                station.sendto(datagram, (HOST, station_port))
            elif bridge_at:
                bridge.sendto(datagram, bridge_at)


main()
