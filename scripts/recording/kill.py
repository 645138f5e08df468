#!/usr/bin/env python3
"""Kills a recording program with SIGKILL again and again, and looks at what each file still holds.

Usage: kill.py CLASSPATH [TIMES]    CLASSPATH as of ./u2sa (target/u2sa/lib/*); TIMES: default 100

A writer program (KilledWriter.java beside this file) publishes numbered messages on a bus with a Recorder, and says which it has
published; it is killed three to five seconds after its start, when its classes are loaded. The file, recovered, must hold all messages from
the first to some last one, without a gap; how old that one was at the kill is measured. Exit code 0: no gap, and none older than a second was
lost. On a busy machine the writing thread may wait longer for a processor than that: judge the figures.
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from mcap.reader import make_reader
import cbor2

class_path = sys.argv[1]
times = int(sys.argv[2]) if len(sys.argv) > 2 else 100
here = pathlib.Path(__file__).resolve().parent
source = random.Random(1)
ages = []
with tempfile.TemporaryDirectory() as folder:
    subprocess.run(["javac", "-d", folder, "-cp", class_path, str(here / "KilledWriter.java")], check=True)
    java = ["java", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", f"{folder}:{class_path}"]
    for number in range(times):
        run = pathlib.Path(folder) / str(number)
        run.mkdir()
        writer = subprocess.Popen(java + ["KilledWriter", str(run)], stdout=subprocess.PIPE, text=True)
        writer.stdout.readline()  # it has begun
        time.sleep(source.uniform(3.0, 5.0))
        killed = time.time()
        os.kill(writer.pid, signal.SIGKILL)
        writer.wait()
        whole = run / "whole.mcap"
        subprocess.run(java + ["org.u2sa.gcs.Main", "recover", str(run / "recording.mcap"), "--out", str(whole)], check=True,
                       stdout=subprocess.DEVNULL)
        with open(whole, "rb") as stream:
            found = [(int(cbor2.loads(message.data)["timestamp"]), message.log_time / 1e9)
                     for _, _, message in make_reader(stream).iter_messages(topics=["u2sa/rover/state/StateInformation"])]
        numbers = [n for n, _ in found]
        if numbers != list(range(len(numbers))):
            sys.exit(f"kill {number}: messages are missing among the first {len(numbers)}")
        if not found:
            sys.exit(f"kill {number}: the file holds no message")
        ages.append(killed - found[-1][1])
        for file in run.iterdir():
            file.unlink()
ages.sort()
late = sum(age > 1.0 for age in ages)
print(f"{times} kills, no gap; age of the last message found: median {ages[times // 2]:.2f} s, longest {ages[-1]:.2f} s, {late} over 1 s")
sys.exit(1 if late else 0)
