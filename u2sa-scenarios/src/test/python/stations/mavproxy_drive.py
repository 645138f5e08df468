"""MAVProxy without a screen operates a demo; every answer is awaited.

    python3 mavproxy_drive.py CONNECTION rover|plane     such as tcp:127.0.0.1:5760
"""
import queue
import re
import subprocess
import sys
import threading
import time

PATIENCE_S = 120.0


class MavProxy:
    def __init__(self, address):
        self.process = subprocess.Popen(
            [sys.executable, "-u", "-m", "MAVProxy.mavproxy", "--master=" + address, "--nowait", "--state-basedir=."],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, bufsize=1)
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()
        self.began = time.monotonic()

    def read(self):
        for line in self.process.stdout:
            self.lines.put(line.rstrip())
        self.lines.put(None)

    def say(self, command):
        print("%6.1f > %s" % (time.monotonic() - self.began, command))
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()

    def expect(self, pattern, patience=PATIENCE_S):
        end = time.monotonic() + patience
        while True:
            try:
                line = self.lines.get(timeout=max(0.01, end - time.monotonic()))
            except queue.Empty:
                sys.exit("FAILED: no \"%s\" within %g s" % (pattern, patience))
            if line is None:
                sys.exit("FAILED: MAVProxy ended before \"%s\"" % pattern)
            if line:
                print("%6.1f   %s" % (time.monotonic() - self.began, line))
            found = re.search(pattern, line)
            if found:
                return found

    def ask(self, command, pattern, patience=PATIENCE_S):
        self.say(command)
        return self.expect(pattern, patience)


def part(path, target, items):
    """Home and the first items of a list of waypoints."""
    with open(path, encoding="ascii") as lines:
        kept = lines.read().splitlines()[: items + 2]
    with open(target, "w", encoding="ascii") as out:
        out.write("\n".join(kept) + "\n")


def until(proxy, command, pattern, wanted, patience=PATIENCE_S):
    """Repeats a command whose answer has a value, until it is the one wanted."""
    end = time.monotonic() + patience
    while abs(float(proxy.ask(command, pattern).group(1)) - wanted) > 1e-6:
        if time.monotonic() > end:
            sys.exit("FAILED: %s is not %s" % (command, wanted))
        time.sleep(1.0)


def parameter(proxy, name, good, bad):
    show, shown = "param show " + name, name + r"\s+([-0-9.]+)"
    value = float(proxy.ask(show, shown).group(1))
    proxy.say("param set %s %s" % (name, good))
    until(proxy, show, shown, good)
    proxy.ask("param set %s %s" % (name, bad), "AP: .* not set: ")
    until(proxy, show, shown, good)
    proxy.say("param set %s %s" % (name, value))
    until(proxy, show, shown, value)


def fly(proxy, items, patience):
    """From the first to the last item; MAVProxy announces each that the vehicle turns to, the second perhaps before the mode."""
    proxy.say("mode AUTO")
    for number in range(2, items + 1):
        proxy.expect(r"waypoint %d$" % number, patience)


def mission(proxy, hold, items):
    proxy.ask("wp list", r"Requesting \d+ waypoints")
    proxy.ask("wp save all.txt", r"Saved \d+ waypoints")
    part("all.txt", "some.txt", items)
    proxy.ask("mode " + hold, "Mode " + hold)
    proxy.ask("wp load some.txt", "Got MISSION_ACK: TYPE_MISSION: ACCEPTED")
    proxy.ask("wp list", r"Requesting %d waypoints" % (items + 1))
    proxy.ask("wp save back.txt", r"Saved %d waypoints" % (items + 1))
    with open("some.txt", encoding="ascii") as sent, open("back.txt", encoding="ascii") as received:
        for there, back in zip(sent.read().splitlines()[2:], received.read().splitlines()[2:]):
            there, back = there.split("\t"), back.split("\t")
            if there[3] != back[3] or any(abs(float(there[i]) - float(back[i])) > 1e-6 for i in (8, 9)):
                sys.exit("FAILED: sent %s, read back %s" % (there, back))
    proxy.ask("fence list", "(?i)fence")


def rover(proxy):
    parameter(proxy, "SAFM_BRAKING", 0.7, -1)
    mission(proxy, "HOLD", 6)
    proxy.ask("disarm", "DISARMED")
    proxy.ask("arm throttle", "(?<!DIS)ARMED")
    proxy.ask("mode RTL", "Mode RTL")
    proxy.ask("mode HOLD", "Mode HOLD")
    fly(proxy, 6, 300.0)
    until(proxy, "status MISSION_ITEM_REACHED", r"MISSION_ITEM_REACHED \{seq : (\d+)\}", 6)  # the demo ends soon


def plane(proxy):
    proxy.expect(r"height 1\d\d$", 600.0)  # it takes off by itself
    parameter(proxy, "SAFM_TURN_BANK", 0.4, 9)
    mission(proxy, "LOITER", 10)
    proxy.ask("mode RTL", "Mode RTL")
    proxy.ask("mode LOITER", "Mode LOITER")
    fly(proxy, 10, 900.0)  # at the last waypoint the demo ends


proxy = MavProxy(sys.argv[1])
try:
    proxy.expect(r"Received \d+ parameters")
    {"rover": rover, "plane": plane}[sys.argv[2]](proxy)
    print("done")
finally:
    proxy.process.kill()
