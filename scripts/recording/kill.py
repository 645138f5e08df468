#!/usr/bin/env python3
"""Kills a recording program with SIGKILL again and again, and looks at what each file still holds.

Usage: kill.py CLASSPATH [TIMES]    CLASSPATH as of ./u2sa (target/u2sa/lib/*); TIMES: default 100

A writer program (KilledWriter.java beside this file) publishes numbered messages on a bus with a Recorder, and says which it has
published, and when; it is killed three to five seconds after its start, when its classes are loaded. The file, recovered, must hold all messages from
the first to some last one, without a gap. What was lost is what was published after that one; its age at the kill is measured from the first lost
message. Where the publisher itself waits for a processor, nothing is published, and so nothing lost: how long it had been silent is told as well.
Exit code 0: no gap, and nothing older than a second was lost.
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time

from mcap.reader import make_reader
import cbor2

class_path = sys.argv[1]
times = int(sys.argv[2]) if len(sys.argv) > 2 else 100
here = pathlib.Path(__file__).resolve().parent
source = random.Random(1)
ages = []
silent = []
with tempfile.TemporaryDirectory() as folder:
    subprocess.run(["javac", "-d", folder, "-cp", class_path, str(here / "KilledWriter.java")], check=True)
    java = ["java", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-cp", f"{folder}:{class_path}"]
    for number in range(times):
        run = pathlib.Path(folder) / str(number)
        run.mkdir()
        writer = subprocess.Popen(java + ["KilledWriter", str(run)], stdout=subprocess.PIPE, text=True)
        writer.stdout.readline()  # it has begun
        lines = []
        reader = threading.Thread(target=lambda: lines.extend(writer.stdout))  # a full pipe would hold the publisher up
        reader.start()
        time.sleep(source.uniform(3.0, 5.0))
        killed = time.time()
        os.kill(writer.pid, signal.SIGKILL)
        writer.wait()
        reader.join()
        published = [int(line.split()[1]) / 1e6 for line in lines if line.endswith("\n")]
        whole = run / "whole.mcap"
        subprocess.run(java + ["org.u2sa.cli.Main", "recover", str(run / "recording.mcap"), "--out", str(whole)], check=True,
                       stdout=subprocess.DEVNULL)
        with open(whole, "rb") as stream:
            found = [round(cbor2.loads(message.data)["z"])
                     for _, _, message in make_reader(stream).iter_messages(topics=["u2sa/rover/state/StateInformation"])]
        if found != list(range(len(found))):
            sys.exit(f"kill {number}: messages are missing among the first {len(found)}")
        ages.append(killed - published[len(found)] if len(found) < len(published) else 0.0)
        silent.append(killed - published[-1])
        print(f"kill {number}: {len(published)} published, {len(found)} found, lost {ages[-1]:.2f} s, publisher silent for {silent[-1]:.2f} s", flush=True)
        for file in run.iterdir():
            file.unlink()
ages.sort()
late = sum(age > 1.0 for age in ages)
print(f"{times} kills, no gap; lost: median {ages[times // 2]:.2f} s, most {ages[-1]:.2f} s, {late} times more than 1 s; "
      f"publisher silent before the kill for {max(silent):.2f} s at most")
sys.exit(1 if late else 0)
