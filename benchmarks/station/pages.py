#!/usr/bin/env python3
"""What the operator's page costs: many vehicles on one page, and many pages on one vehicle.

    pages.py vehicles WEB_PORT BROKER_PORT USER TOKEN_FILE [VEHICLES] [SECONDS]
        plays VEHICLES vehicles at 10 Hz through the broker, opens the page in Chromium; prints the time between two
        pictures, and the lag from a state's timestamp until the picture after its arrival
    pages.py readers WEB_PORT BROKER_PORT USER TOKEN_FILE [PAGES] [SECONDS]
        prints the longest p99 of callbacks that each service of the running vehicle reports, without and with PAGES
        clients that subscribe over the WebSocket to what the page subscribes to, in turn, three times
    pages.py soak WEB_PORT BROKER_PORT USER TOKEN_FILE [VEHICLES] [MINUTES]
        as vehicles, with 10 of them; prints a line each minute with the heap after a collection

Needs paho-mqtt 1, cbor2, playwright and Debian's chromium. Start a vehicle first: ./u2sa demo ugv --realtime --web 8080
"""
import math
import os
import pathlib
import select
import socket
import statistics
import struct
import sys
import threading
import time
import uuid

import cbor2
import paho.mqtt.client as mqtt

HOOK = """
window.lags = []; window.frames = []; window.marks = []; window.received = 0;
const own = Object.getOwnPropertyDescriptor(WebSocket.prototype, 'onmessage');
const key = new TextEncoder().encode('timestamp');
Object.defineProperty(WebSocket.prototype, 'onmessage', {get: own.get, set(handler) {
  own.set.call(this, handler && (event => { handler(event); note(new Uint8Array(event.data)); }));
}});
function note(bytes) {
  for (let i = 0; i + 18 < bytes.length; i++) {
    if (key.every((byte, j) => bytes[i + j] === byte) && bytes[i + 9] === 0x1b) {
      const us = Number(new DataView(bytes.buffer, bytes.byteOffset + i + 10, 8).getBigUint64(0));
      if (Math.abs(Date.now() - us / 1000) < 60000) { window.marks.push(us / 1000); window.received++; }
    }
  }
}
let last = 0;
(function frame(now) {
  requestAnimationFrame(frame);
  if (last && now) window.frames.push(now - last);
  last = now;
  const at = Date.now();
  for (const mark of window.marks.splice(0)) window.lags.push(at - mark);
})();
"""


def client(broker_port, user, token):
    made = mqtt.Client()
    made.username_pw_set(user, token)
    made.connect("127.0.0.1", broker_port, keepalive=60)
    made.loop_start()
    return made


def share(values, part):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))] if ordered else math.nan


def play(publisher, count, stop):
    begun = time.time()
    tick = 0
    while not stop.is_set():
        now = time.time()
        for i in range(count):
            angle = 0.05 * (now - begun) + i
            fields = {"timestamp": int(now * 1e6), "referenceFrame": "GLOBAL", "x": -157.9 + 0.02 * math.cos(angle),
                      "y": 21.3 + 0.0005 * i + 0.02 * math.sin(angle), "z": 100.0, "psi": angle % 6.28, "xDot": 20.0, "yDot": 0.0}
            publisher.publish(f"u2sa/v{i:02d}/state/StateInformation", cbor2.dumps(fields), qos=0)
        tick += 1
        time.sleep(max(0.0, begun + 0.1 * tick - time.time()))


def busy(inspector):
    return next(each["value"] for each in inspector.send("Performance.getMetrics")["metrics"] if each["name"] == "TaskDuration")


def vehicles(web_port, broker_port, user, token, count=50, seconds=60):
    from playwright.sync_api import sync_playwright

    publisher = client(broker_port, user, token)
    stop = threading.Event()
    threading.Thread(target=play, args=(publisher, count, stop), daemon=True).start()
    with sync_playwright() as p:
        browser = p.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox", "--disable-gpu"])
        page = browser.new_page(viewport={"width": 1400, "height": 900})
        page.add_init_script(HOOK)
        page.goto(f"http://127.0.0.1:{web_port}/#{token}")
        page.wait_for_timeout(5000)
        page.click("#fit")
        page.select_option("#vehicle", "v00")
        inspector = page.context.new_cdp_session(page)
        inspector.send("Performance.enable", {"timeDomain": "threadTicks"})  # processor time of the page's thread
        before = busy(inspector)
        page.evaluate("lags.length = 0; frames.length = 0; received = 0")
        page.wait_for_timeout(1000 * seconds)
        worked = busy(inspector) - before
        lags, frames, received, heap = page.evaluate("[lags, frames, received, performance.memory.usedJSHeapSize]")
        page.screenshot(path=os.environ.get("U2SA_PICTURE", "vehicles.png"))
        browser.close()
    stop.set()
    print(f"{count} vehicles at 10 Hz, {seconds} s, load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores: {received / seconds:.0f} messages/s arrived")
    print(f"time between pictures: p50 {share(frames, 0.5):.0f} ms, p95 {share(frames, 0.95):.0f} ms, p99 {share(frames, 0.99):.0f} ms")
    print(f"lag until the next picture: p50 {share(lags, 0.5):.0f} ms, p95 {share(lags, 0.95):.0f} ms, p99 {share(lags, 0.99):.0f} ms; heap {heap / 1e6:.1f} MB")
    print(f"processor time of the page's thread: {100 * worked / seconds:.0f} % of a core")


def soak(web_port, broker_port, user, token, count=10, minutes=30):
    from playwright.sync_api import sync_playwright

    publisher = client(broker_port, user, token)
    threading.Thread(target=play, args=(publisher, count, threading.Event()), daemon=True).start()
    with sync_playwright() as p:
        browser = p.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox", "--disable-gpu", "--enable-precise-memory-info"])
        page = browser.new_page(viewport={"width": 1400, "height": 900})
        page.add_init_script(HOOK)
        page.goto(f"http://127.0.0.1:{web_port}/#{token}")
        page.wait_for_timeout(5000)
        page.select_option("#vehicle", "v00")
        inspector = page.context.new_cdp_session(page)
        inspector.send("Performance.enable", {"timeDomain": "threadTicks"})
        for minute in range(minutes):
            before = busy(inspector)
            page.evaluate("lags.length = 0; frames.length = 0; received = 0")
            page.wait_for_timeout(60_000)
            worked = busy(inspector) - before
            lags, frames, received = page.evaluate("[lags, frames, received]")
            page.evaluate("lags.length = 0; frames.length = 0")
            inspector.send("HeapProfiler.collectGarbage")
            heap = page.evaluate("performance.memory.usedJSHeapSize")
            print(f"{minute + 1:3d} min: heap {heap / 1e6:6.2f} MB, lag p50 {share(lags, 0.5):4.0f} p95 {share(lags, 0.95):4.0f} ms, pictures p95 {share(frames, 0.95):4.0f} ms, "
                  f"{received / 60:.0f} messages/s, {100 * worked / 60:.0f} % of a core, load {os.getloadavg()[0]:.1f}", flush=True)
        browser.close()


CHANNELS = ["mission", "service-orders", "arming-state", "failsafe", "emergency-stop", "goals", "conditions", "configuration",
            "discovery", "functionality", "state", "objects", "grid", "plans", "navigation", "power", "health", "goal-reports"]


def text(value):
    encoded = value.encode()
    return struct.pack(">H", len(encoded)) + encoded


def packet(kind, body):
    """An MQTT packet shorter than 16 KiB."""
    size = bytes([len(body)]) if len(body) < 128 else bytes([len(body) % 128 | 128, len(body) // 128])
    return bytes([kind]) + size + body


def frame(payload):
    """A WebSocket frame of a client, under the mask 0."""
    size = bytes([128 | len(payload)]) if len(payload) < 126 else b"\xfe" + struct.pack(">H", len(payload))
    return b"\x82" + size + bytes(4) + payload


def reader(web_port, user, token):
    """A connection that subscribes to what the page subscribes to; whatever arrives need only be read and dropped."""
    made = socket.create_connection(("127.0.0.1", web_port), timeout=10)
    own = f"127.0.0.1:{web_port}"
    made.sendall(f"GET /mqtt HTTP/1.1\r\nHost: {own}\r\nOrigin: http://{own}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                 f"Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: mqtt\r\n\r\n".encode())
    answer = made.recv(4096)
    assert answer.startswith(b"HTTP/1.1 101"), answer
    connect = text("MQTT") + bytes([4, 0xC2]) + struct.pack(">H", 600) + text(f"reader-{uuid.uuid4().hex[:12]}") + text(user) + text(token)
    made.sendall(frame(packet(0x10, connect)))
    filters = b"".join(text(f"u2sa/+/{channel}/#") + b"\0" for channel in CHANNELS)
    made.sendall(frame(packet(0x82, struct.pack(">H", 1) + filters)))
    return made


def drain(connections, seconds):
    """Reads what arrives and drops it; returns the number of bytes."""
    end = time.monotonic() + seconds
    count = 0
    while (left := end - time.monotonic()) > 0:
        for ready in select.select(connections, [], [], left)[0]:
            received = len(ready.recv(1 << 16))
            assert received > 0, "the vehicle ended a connection"
            count += received
    return count


def readers(web_port, broker_port, user, token, count=20, seconds=20):
    heard = {}
    watcher = client(broker_port, user, token)

    def health(_, __, message):
        report = cbor2.loads(message.payload)
        if report.get("callbackP99") is not None:
            heard.setdefault(report["serviceName"], []).append(1000 * report["callbackP99"])

    watcher.on_message = health
    watcher.subscribe("u2sa/+/health/#")
    for _ in range(3):
        for pages in (0, count):
            opened = [reader(web_port, user, token) for _ in range(pages)]
            drain(opened, 5)
            heard.clear()
            arrived = drain(opened, seconds)
            medians = ", ".join(f"{name} {statistics.median(values):.2f}" for name, values in sorted(heard.items()))
            print(f"{pages} pages, {arrived / seconds / 1000:.0f} kB/s read, load {os.getloadavg()[0]:.1f}: p99 of callbacks [ms]: {medians}", flush=True)
            for each in opened:
                each.close()


if __name__ == "__main__":
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    kind, web, broker, who, file, *numbers = sys.argv[1:]
    run = {"vehicles": vehicles, "readers": readers, "soak": soak}[kind]
    run(int(web), int(broker), who, pathlib.Path(file).read_text().strip(), *map(int, numbers))
