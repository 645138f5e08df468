#!/usr/bin/env python3
"""Kills a recording program with SIGKILL again and again, and looks at what each file still holds.

Usage: kill.py CLASSPATH [TIMES]    CLASSPATH as of ./u2sa (target/u2sa/lib/*); TIMES: default 100

A writer program (KilledWriter.java beside this file) publishes numbered messages on a bus with a Recorder, and says which it has
published; it is killed after a random time. The file, recovered, must hold every message published a second or more before the kill,
without a gap. Exit code 0: all did.
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
worst = 0.0
with tempfile.TemporaryDirectory() as folder:
    subprocess.run(["javac", "-d", folder, "-cp", class_path, str(here / "KilledWriter.java")], check=True)
    java = ["java", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", f"{folder}:{class_path}"]
    for number in range(times):
        run = pathlib.Path(folder) / str(number)
        run.mkdir()
        writer = subprocess.Popen(java + ["KilledWriter", str(run)], stdout=subprocess.PIPE, text=True)
        writer.stdout.readline()  # it has begun
        time.sleep(source.uniform(0.3, 2.5))
        killed = time.time()
        os.kill(writer.pid, signal.SIGKILL)
        writer.wait()
        said = [line.split() for line in writer.stdout.read().splitlines() if line.count(" ") == 1]
        old_enough = [int(n) for n, at in said if float(at) / 1e6 < killed - 1.0]
        whole = run / "whole.mcap"
        subprocess.run(java + ["org.u2sa.gcs.Main", "recover", str(run / "recording.mcap"), "--out", str(whole)], check=True,
                       stdout=subprocess.DEVNULL)
        with open(whole, "rb") as stream:
            found = [(int(cbor2.loads(message.data)["timestamp"]), message.log_time / 1e9)
                     for _, _, message in make_reader(stream).iter_messages(topics=["u2sa/rover/state/StateInformation"])]
        numbers = [n for n, _ in found]
        if numbers != list(range(len(numbers))):
            sys.exit(f"kill {number}: messages are missing among the first {len(numbers)}")
        if old_enough and (not numbers or numbers[-1] < old_enough[-1]):
            sys.exit(f"kill {number}: message {old_enough[-1]} was a second old, but the last one found is {numbers[-1:]}")
        if found:
            worst = max(worst, killed - found[-1][1])
        for file in run.iterdir():
            file.unlink()
print(f"{times} kills: nothing older than a second was lost; the last message found was at most {worst:.2f} s old")
