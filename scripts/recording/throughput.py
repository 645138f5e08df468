#!/usr/bin/env python3
"""Messages and bytes a second that Python's own MCAP writer takes (PyPI mcap), for benchmarks/RecordThroughput.java's messages.

Usage: throughput.py [FOLDER]    FOLDER is in memory; default: /dev/shm
"""
import os
import random
import sys
import tempfile
import time

from mcap.writer import CompressionType, Writer

folder = sys.argv[1] if len(sys.argv) > 1 else "/dev/shm"
source = random.Random(1)
for compression in (CompressionType.NONE, CompressionType.LZ4):
    for size in (100, 1_000, 10_000):
        payloads = [bytes(source.randrange(256) if i % 4 == 0 else i & 255 for i in range(size)) for _ in range(64)]
        messages = min(200_000, 100_000_000 // size)
        handle, path = tempfile.mkstemp(dir=folder)
        os.close(handle)
        began = time.perf_counter()
        with open(path, "wb") as stream:
            writer = Writer(stream, compression=compression)
            writer.start()
            channel = writer.register_channel("bytes", "cbor", writer.register_schema("Bytes", "", b""))
            for i in range(messages):
                writer.add_message(channel, i * 1_000, payloads[i % 64], i * 1_000, i)
            writer.finish()
        seconds = time.perf_counter() - began
        os.remove(path)
        print(f"{compression.name:4} {size:6} B: {messages / seconds / 1e6:5.2f} million messages/s, {messages * size / seconds / 1e6:6.0f} MB/s")
