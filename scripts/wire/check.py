#!/usr/bin/env python3
"""Holds what a broker carries to docs/wire-protocol.md, message by message: topics, channels, QoS, retained flags, wills,
fields, kinds, ranges, units, order and bytes; asks every service who it is, what it publishes and what its variables are,
and one of them for what it must refuse. Knows nothing of U2SA but that page, and uses cbor2 and paho-mqtt. Says at the end
what it did not see. Exit code 1: something differs.

    python3 scripts/wire/check.py --broker localhost:1883 --seconds 20
    python3 scripts/wire/check.py --wills 3         # then says "kill now", and waits for so many wills
"""
import argparse
import collections
import pathlib
import sys
import time
import uuid

import cbor2
import paho.mqtt.client as mqtt

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "clients" / "python"))
from u2sa.link import local_token, loopback

from rules import CHANNELS, CHECKED, MESSAGES, STANDARD, WILL, Difference, check, split
from talk import Talk

CONTRACT = ("discovery", "functionality", "stop", "configuration", "health")
STRAY_S = 30.0
WITHIN_S = 60.0
AGAIN_S = 5.0


class Watch:
    """One subscription to everything; what does not hold is kept, by its words."""

    def __init__(self, host, port):
        self.topics = collections.Counter()
        self.retained = set()
        self.wrong = collections.Counter()
        self.answers = collections.defaultdict(dict)  # newest message by class and service
        self.systems = set()
        self.numbers = {}  # newest by sender and topic
        self.lost = 0
        version2 = getattr(mqtt, "CallbackAPIVersion", None)
        name = f"check-{uuid.uuid4()}"
        self.client = mqtt.Client(version2.VERSION2, name) if version2 else mqtt.Client(name)
        self.client.on_connect = lambda client, *_rest: client.subscribe("u2sa/#", 2)
        self.client.on_message = self.message
        self.client.connect(self._local(host, port), port)
        self.client.loop_start()

    def _local(self, host, port):
        """The address to connect to; over loopback with the token of this account, since it asks for changes that are refused."""
        address = loopback(host)
        if address is None:
            return host
        user, token = local_token(address, port)
        if user is None:
            return host
        self.client.username_pw_set(user, token)
        return address

    def message(self, _client, _data, packet):
        self.topics[packet.topic] += 1
        if packet.retain:
            self.retained.add(packet.topic)
        try:
            now_s = time.time()
            message, origin = check(packet.topic, packet.qos, packet.payload, now_s)
            if now_s - message.get("timestamp", now_s * 1e6) / 1e6 > STRAY_S and not packet.retain:
                raise Difference("its timestamp is not of now: microseconds since 1970 are expected")
            self.take(packet, message, origin)
        except (Difference, cbor2.CBORDecodeError, ValueError, EOFError, TypeError) as e:
            self.wrong[f"{packet.topic}: {e}"] += 1

    def take(self, packet, message, origin):
        self.systems.add(message["systemId"])
        if "serviceName" in message:
            self.answers[split(packet.topic)[2][-1]][message["serviceName"]] = message
        if origin is not None:
            before = self.numbers.get((origin[0], packet.topic))
            self.lost += max(0, origin[1] - before - 1) if before is not None else 0
            self.numbers[(origin[0], packet.topic)] = max(origin[1], before or 0)

    def channels(self):
        return {topic.split("/")[2] for topic in list(self.topics) if topic.count("/") > 2}

    def end(self):
        self.client.disconnect()
        self.client.loop_stop()


def wait(condition, within_s=WITHIN_S):
    until = time.monotonic() + within_s
    while not condition() and time.monotonic() < until:
        time.sleep(0.05)


def talk(live, service):
    """Asks until all is answered, or for long enough; what is still open then."""
    still_open = []
    for system in sorted(live.systems):
        conversation = Talk(system, service)
        conversation.ask_one(live.client)
        until = time.monotonic() + WITHIN_S
        while time.monotonic() < until:
            conversation.ask_all(live.client)
            wait(lambda: not conversation.unanswered(live.answers), AGAIN_S)
            if not conversation.unanswered(live.answers):
                break
        still_open += conversation.unanswered(live.answers)
    return still_open


def retained_as_said(expected, late):
    """Compares what a late subscriber got with the table. expected: topics seen before it came."""
    kept = [topic for topic in sorted(expected) if is_kept(topic)]
    wait(lambda: late.retained.issuperset(kept), 10.0)
    yield from (f"{topic}: not retained, the table says yes" for topic in kept if topic not in late.retained)
    yield from (f"{topic}: retained, the table says no" for topic in sorted(late.retained) if not is_kept(topic))


def is_kept(topic):
    try:
        return CHANNELS[split(topic)[1]][1]
    except Difference:
        return False


def answered_as_said(live):
    """Compares the services' answers with one another and with the topics seen."""
    for name, answer in sorted(live.answers["DiscoveryResponse"].items()):
        report = live.answers["HealthReport"].get(name, {})
        if report.get("instance") != answer.get("instance"):
            yield f"{name}: instance differs between discovery and health"
    publishes = [entry for answer in live.answers["FunctionalityResponse"].values() for entry in answer["publishes"]]
    for topic in sorted(live.topics):
        try:
            _system, channel, chain, _source = split(topic)
        except Difference:
            continue
        path = "/".join((channel, *chain)) + "/"
        asked = channel in CONTRACT or chain[-1] in ("ServiceOrder", "ArmCommand")
        if not asked and not any(path.startswith(entry.rstrip("/") + "/") for entry in publishes):
            yield f"{topic}: no service says that it publishes {path[:-1]}"


def report(live, late, wrong):
    for line, count in wrong.most_common(30):
        print(f"{count} x {line}")
    for topic in sorted(live.topics):
        print(f"{live.topics[topic]:6} {'retained' if topic in late.retained else '        '} {topic}")
    channels, classes = STANDARD
    seen = live.channels()
    print(f"services: {', '.join(sorted(live.answers['DiscoveryResponse'])) or 'none'}")
    print(f"wills: {', '.join(sorted(live.answers[WILL])) or 'none'}")
    print(f"not seen, channels: {', '.join(name for name in channels if name not in seen) or 'none'}")
    print("not seen, classes: "
          + (", ".join(name for name in classes if name not in CHECKED and not MESSAGES[name][1]) or "none"))
    print(f"numbered by {len({sender for sender, _topic in live.numbers})} senders, {live.lost} messages lost on the way")
    print(f"{sum(live.topics.values())} messages on {len(live.topics)} topics checked, {sum(wrong.values())} differences")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--broker", default="localhost:1883", metavar="HOST[:PORT]")
    parser.add_argument("--seconds", type=float, default=20.0, help="how long to watch (default: %(default)s)")
    parser.add_argument("--expect", default="health", metavar="CHANNEL,…",
                        help="watch for longer, if need be, until these were seen (default: %(default)s)")
    parser.add_argument("--service", default="PathPlanner", help="a service in a launcher's process, asked for what it must refuse (default: %(default)s)")
    parser.add_argument("--wills", type=int, default=0, help="wait for so many wills at the end")
    arguments = parser.parse_args()
    host, _, port = arguments.broker.partition(":")
    try:
        live = Watch(host, int(port or 1883))
        time.sleep(arguments.seconds)
        expected = set(filter(None, arguments.expect.split(",")))
        wait(lambda: live.answers["HealthReport"] and expected <= live.channels())
        wrong = collections.Counter(talk(live, arguments.service))
        before = set(list(live.topics))
        late = Watch(host, int(port or 1883))  # gets what is retained
    except OSError as e:
        sys.exit(f"no broker at {arguments.broker}: {e}")
    wrong.update(retained_as_said(before, late))
    late.end()
    wrong.update(answered_as_said(live))
    wrong.update(f"channel {name} was never seen" for name in sorted(expected - live.channels()))
    if arguments.wills:
        print("kill now", flush=True)
        wait(lambda: len(live.answers[WILL]) >= arguments.wills)
        wrong.update([f"{len(live.answers[WILL])} wills, expected {arguments.wills}"]
                     if len(live.answers[WILL]) < arguments.wills else [])
    live.end()
    wrong += live.wrong + late.wrong
    report(live, late, wrong)
    return 1 if wrong or not live.topics else 0


if __name__ == "__main__":
    sys.exit(main())
