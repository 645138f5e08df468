#!/usr/bin/env python3
"""The operator's page over a bad network: a ground vehicle in a network namespace, Chromium outside of it.

    link.py FOLDER [DELAY_MS JITTER_MS LOSS_PERCENT [SECONDS]]

FOLDER is new. Delay and loss apply to each direction (default 200 ± 40 ms, 5 %). Prints how much of the vehicle's state arrives
each second and how old it is, how long 20 orders take to be answered or reported as failed, and how long after the link is cut the
supervised vehicle enters its failsafe. Needs root, playwright and Debian's chromium.
"""
import pathlib
import re
import statistics
import subprocess
import sys
import time

from playwright.sync_api import sync_playwright

from pages import HOOK

ROOT = pathlib.Path(__file__).resolve().parents[2]
WEB = 8080


class Lan:
    """A host named `vehicle` behind a link that can be shaped; scripts/network/lan."""

    def __init__(self):
        self.script = subprocess.Popen([ROOT / "scripts/network/lan", "--shaped", "vehicle"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        words = self.script.stdout.readline().split()
        self.shaping = words[2]
        _, self.address, self.namespace = words[3].split("=")

    def order(self, text):
        self.script.stdin.write(text + "\n")
        self.script.stdin.flush()
        assert self.script.stdout.readline().strip() == "done", text

    def close(self):
        self.script.stdin.close()
        self.script.wait(30)


def part(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def until(page, expression, seconds):
    """Waits for an expression; the page's policy forbids what playwright would do."""
    end = time.monotonic() + seconds
    while not page.evaluate(expression):
        if time.monotonic() > end:
            raise TimeoutError(expression)
        time.sleep(0.02)


def start(lan, folder):
    settings = {"BIND ADDRESS": "0.0.0.0", "LOCAL COMMANDS": "everybody", "ALLOW INSECURE NETWORK": "true"}
    command = ["ip", "netns", "exec", lan.namespace, ROOT / "u2sa", "demo", "ugv", "--realtime", f"--web={WEB}", f"--out={folder / 'run'}"]
    command += [f"--set=CommunicationManager:{name}={value}" for name, value in settings.items()]
    log = open(folder / "vehicle.log", "w")
    vehicle = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT)
    while "Operator's page" not in (folder / "vehicle.log").read_text():
        if vehicle.poll() is not None:
            sys.exit((folder / "vehicle.log").read_text())
        time.sleep(0.2)
    return vehicle


def telemetry(page, seconds):
    """States per second, and their age when drawn [ms]."""
    page.evaluate("window.lags.length = 0; window.received = 0")
    counts = []
    for _ in range(seconds):
        time.sleep(1.0)
        counts.append(page.evaluate("(() => { const n = window.received; window.received = 0; return n; })()"))
    return counts, page.evaluate("window.lags")


def order(page, button):
    """Time until an order has an outcome [s], and what it is."""
    until(page, f"!document.getElementById('{button}').disabled", 30)
    began = time.monotonic()
    page.evaluate(f"document.getElementById('outcome').textContent = ''; document.getElementById('{button}').click()")
    until(page, "!['', '…'].includes(document.getElementById('outcome').textContent)", 30)
    return time.monotonic() - began, page.inner_text("#outcome")


def failsafe_after(page, lan, folder):
    """Cuts the link of the supervised vehicle; time until the Safety Manager acts [s]."""
    page.check("#supervise")
    time.sleep(5)
    log = folder / "run/logs/SafetyManager.log"
    before = len(log.read_text().splitlines())
    lan.order("cut vehicle")
    began = time.time()
    line = ""
    while not line and time.time() - began < 30:
        time.sleep(0.05)
        line = next((each for each in log.read_text().splitlines()[before:] if re.search("operator", each)), "")
    took = time.time() - began
    until(page, "document.getElementById('link').textContent.startsWith('LINK LOST')", 30)
    noticed = time.time() - began
    lan.order("mend vehicle")
    until(page, "document.getElementById('link').textContent.startsWith('link ')", 60)
    return took, line, noticed


def main(folder, delay=200.0, jitter=40.0, loss=5.0, seconds=60):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    lan = Lan()
    vehicle = start(lan, folder)
    try:
        with sync_playwright() as play:
            browser = play.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox", "--disable-gpu"])
            page = browser.new_page()
            errors = []
            page.on("pageerror", lambda error: errors.append(str(error)))
            page.add_init_script(HOOK)
            lan.order(f"shape vehicle {delay} {jitter} {loss}")
            page.goto(f"http://{lan.address}:{WEB}/", timeout=60000)
            page.click("#enter")
            until(page, "document.getElementById('doing').textContent.includes('to ')", 60)
            print(f"{lan.shaping}: {delay:g} ± {jitter:g} ms, {loss:g} % loss in each direction; load average {pathlib.Path('/proc/loadavg').read_text().split()[0]}")
            counts, lags = telemetry(page, int(seconds))
            print(f"timed messages a second: least {min(counts)}, median {statistics.median(counts):g}; seconds without: {counts.count(0)} of {len(counts)}")
            print(f"age when drawn: p50 {part(lags, 0.5):.0f} ms, p95 {part(lags, 0.95):.0f} ms, p99 {part(lags, 0.99):.0f} ms")
            taken = [order(page, button) for _ in range(10) for button in ("hold", "resume")]
            times = [took for took, _ in taken]
            failed = [text for _, text in taken if "no answer" in text or "no link" in text]
            print(f"20 orders: p50 {part(times, 0.5):.2f} s, longest {max(times):.2f} s; reported as failed: {len(failed)}")
            took, line, noticed = failsafe_after(page, lan, folder)
            print(f"link cut while supervised: {took:.1f} s until: {line.strip()}")
            print(f"the page said LINK LOST within {noticed:.1f} s, and was connected again after the link was; errors: {errors}")
            browser.close()
    finally:
        vehicle.terminate()
        vehicle.wait(30)
        lan.close()


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], *(float(each) for each in sys.argv[2:]))
