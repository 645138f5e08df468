#!/usr/bin/env python3
"""Floods an MQTT broker on 127.0.0.1 over plain sockets, for a few seconds: flood.py PORT CLIENTS SIZE QOS SECONDS.

SIZE: small (a state, 27 bytes), large (a state with 900,000 bytes that readers skip), sources (small ones of 5,000 invented
sensors), unheard (small ones on a channel without listeners). Prints how many packets a second, and payload MB a
second, all clients together got rid of: that includes what still waits in socket buffers, which counts with many clients.
"""
import socket
import struct
import sys
import threading
import time

CHUNK = 65_536


def text(value):
    data = value.encode()
    return (bytes([0x60 + len(data)]) if len(data) < 24 else bytes([0x78, len(data)])) + data


def state(sensor, padding=0):
    head = bytes([0xA3 if padding else 0xA2]) + text("sensorName") + text(sensor) + text("x") + b"\xfb" + struct.pack(">d", 1.0)
    return head + (text("pad") + b"\x5a" + struct.pack(">I", padding) + bytes(padding) if padding else b"")


def packet(kind, content):
    length, left = b"", len(content)
    while True:
        length += bytes([left % 128 | (0x80 if left >= 128 else 0)])
        left //= 128
        if not left:
            return bytes([kind]) + length + content


def publish(topic, payload, qos):
    return packet(0x30 | qos << 1, struct.pack(">H", len(topic)) + topic.encode() + (b"\0\7" if qos else b"") + payload)


def connected(port, name):
    client = socket.create_connection(("127.0.0.1", port))
    hello = struct.pack(">H", 4) + b"MQTT\x04\x02" + struct.pack(">H", 60) + struct.pack(">H", len(name)) + name.encode()
    client.sendall(packet(0x10, hello))
    if client.recv(4)[3:] != b"\0":
        sys.exit("refused")
    return client


def read_answers(client):
    try:
        while client.recv(CHUNK):
            pass
    except OSError:
        pass


def flood(client, block, until, sent, index):
    """Sends the block again and again; counts bytes."""
    view = memoryview(block)
    client.settimeout(0.2)
    at = 0
    while time.monotonic() < until:
        try:
            count = client.send(view[at:at + CHUNK])
        except socket.timeout:
            continue
        except OSError:
            return
        sent[index] += count
        at = (at + count) % len(block)


def main():
    port, clients, size, qos, seconds = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3], int(sys.argv[4]), min(10.0, float(sys.argv[5]))
    system = "u2sa/benchmark/"
    topic = system + ("elsewhere" if size == "unheard" else "state") + "/StateInformation"
    if size == "large":
        payloads = [state("flood", 900_000)]
    elif size == "sources":
        payloads = [state("flood%04d" % i) for i in range(5_000)]
    else:
        payloads = [state("flood")] * 2_000
    block = b"".join(publish(topic, payload, qos) for payload in payloads)
    sockets = [connected(port, "flood-%d" % i) for i in range(clients)]
    sent = [0] * clients
    began = time.monotonic()
    threads = [threading.Thread(target=flood, args=(each, block, began + seconds, sent, i)) for i, each in enumerate(sockets)]
    for each in sockets:
        threading.Thread(target=read_answers, args=(each,), daemon=True).start()
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    took = time.monotonic() - began
    blocks = sum(sent) / len(block)
    payload = blocks * sum(map(len, payloads))
    print("%.0f packets/s, %.1f MB/s" % (blocks * len(payloads) / took, payload / took / 1e6), flush=True)
    for each in sockets:
        each.close()


main()
