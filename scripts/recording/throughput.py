#!/usr/bin/env python3
"""Messages and bytes a second that Python's own MCAP writer takes (PyPI mcap), beside ours with the same messages (benchmarks/RecordThroughput.java), row by row.

Usage: throughput.py [CLASSPATH [FOLDER]]    CLASSPATH as of ./u2sa (default: target/u2sa/lib/*); FOLDER is in memory; default: /dev/shm
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from mcap.writer import CompressionType, Writer

home = pathlib.Path(__file__).resolve().parents[2]
class_path = sys.argv[1] if len(sys.argv) > 1 else f"{home}/target/u2sa/lib/*"
folder = sys.argv[2] if len(sys.argv) > 2 else "/dev/shm"
with tempfile.TemporaryDirectory() as classes:
    subprocess.run(["javac", "-d", classes, "-cp", class_path, str(home / "benchmarks/RecordThroughput.java")], check=True)
    for compression in (CompressionType.NONE, CompressionType.LZ4):
        for size in (100, 1_000, 10_000):
            ours = subprocess.run(["java", "-cp", f"{classes}:{class_path}", "RecordThroughput", folder, compression.name, str(size)],
                                  check=True, capture_output=True, text=True)
            print("ours    " + ours.stdout, end="", flush=True)
            bytes_of_all = (pathlib.Path(folder) / f"payloads-{size}").read_bytes()
            payloads = [bytes_of_all[i:i + size] for i in range(0, len(bytes_of_all), size)]
            os.remove(pathlib.Path(folder) / f"payloads-{size}")
            messages = min(100_000, 40_000_000 // size)
            handle, path = tempfile.mkstemp(dir=folder)
            os.close(handle)
            began, used_before = time.perf_counter(), time.process_time()
            with open(path, "wb") as stream:
                writer = Writer(stream, compression=compression)
                writer.start()
                channel = writer.register_channel("bytes", "cbor", writer.register_schema("Bytes", "", b""))
                for i in range(messages):
                    writer.add_message(channel, i * 1_000, payloads[i % len(payloads)], i * 1_000, i)
                writer.finish()
            used, seconds = time.process_time() - used_before, time.perf_counter() - began
            os.remove(path)
            print(f"Python's {compression.name:4} {size:6} B: {messages / seconds / 1e6:5.2f} million messages/s, {messages * size / seconds / 1e6:6.0f} MB/s; "
                  f"by processor time {messages / used / 1e6:5.2f} million/s, {messages * size / used / 1e6:6.0f} MB/s", flush=True)
