#!/usr/bin/env python3
"""Reads U2SA messages (docs/wire-protocol.md) with nothing of U2SA: cbor2, and paho-mqtt for a live broker.

    pip install cbor2
    python3 scripts/wire/decode.py                                  check every golden vector against its JSON
    python3 scripts/wire/decode.py --file message.cbor              print one message
    pip install paho-mqtt
    python3 scripts/wire/decode.py --broker localhost:1883          print what a broker carries
    python3 scripts/wire/decode.py --broker localhost:1883 --topic 'u2sa/cessna/state/#' --count 10
"""
import argparse
import base64
import json
import math
import pathlib
import struct
import sys

try:
    import cbor2
except ImportError:
    sys.exit("decode.py needs cbor2: pip install cbor2")

WIRE = pathlib.Path(__file__).resolve().parent.parent.parent / "docs" / "wire"
GOLDEN = WIRE / "golden"
# Tags of arrays (RFC 8746): of floats, which stand for lists of numbers, and of two dimensions, which stand for lists of points.
FLOATS = {80: ">e", 81: ">f", 82: ">d", 84: "<e", 85: "<f", 86: "<d"}
ROW_MAJOR = 40
LABELS = {int(label): name for label, name in map(str.split, (WIRE / "labels.txt").read_text(encoding="utf-8").splitlines())}


def decode(payload):
    """A message as a dict; ValueError if the bytes are no message."""
    import io
    stream = io.BytesIO(payload)
    try:
        message = cbor2.CBORDecoder(stream).decode()
    except (cbor2.CBORDecodeError, EOFError) as e:
        raise ValueError(f"no CBOR: {e}") from e
    if stream.read(1):
        raise ValueError(f"{len(payload) - stream.tell() + 1} bytes after the message")
    if not isinstance(message, dict) or not all(isinstance(key, (str, int)) for key in message):
        raise ValueError("expected a map with text keys or labels")
    message = named(message)
    check_numbers(message, "message")
    return message


def floats(tag):
    """The numbers of a typed array; ValueError if it has none."""
    try:
        return [item for item, in struct.iter_unpack(FLOATS[tag.tag], tag.value)]
    except (KeyError, TypeError, struct.error) as e:
        raise ValueError(f"tag {tag.tag}: expected a typed array of floats: {e}") from e


def as_list(tag):
    """The list that an array of floats or of two dimensions stands for; any other tag as it is."""
    if tag.tag != ROW_MAJOR:
        return floats(tag) if tag.tag in FLOATS else tag
    try:
        (rows, columns), data = tag.value
        flat = floats(data) if isinstance(data, cbor2.CBORTag) else list(data)
        if rows < 0 or columns < 1 or len(flat) != rows * columns:
            raise ValueError(f"{rows} times {columns} are not {len(flat)}")
        return [flat[begin:begin + columns] for begin in range(0, len(flat), columns)]
    except (TypeError, ValueError) as e:
        raise ValueError(f"tag {tag.tag}: expected two dimensions and as many numbers: {e}") from e


def named(value, untagged=as_list):
    """The value with names for labels, its own and those of the messages in it, and with what `untagged` makes of tags."""
    if isinstance(value, dict):
        return {LABELS.get(key, f"#{key}") if isinstance(key, int) else key: named(item, untagged)
                for key, item in value.items()}
    if isinstance(value, cbor2.CBORTag):
        return untagged(value)
    return [named(item, untagged) for item in value] if isinstance(value, list) else value


def check_numbers(value, where):
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{where}: {value} is not a finite number")
    if isinstance(value, dict):
        for key, item in value.items():
            check_numbers(item, f"{where}.{key}")
    if isinstance(value, list):
        for index, item in enumerate(value):
            check_numbers(item, f"{where}[{index}]")


def as_json(value):
    """What JSON has no type for: bytes as base64."""
    if isinstance(value, bytes):
        return base64.b64encode(value).decode("ascii")
    raise TypeError(f"{value!r} has no form in JSON")


def differences(expected, actual, where):
    """Where two values differ; an int is not a float, and the order of keys counts: it is the order of the wire."""
    if isinstance(actual, bytes):
        actual = as_json(actual)
    if type(expected) is not type(actual):
        return [f"{where}: expected {expected!r}, read {actual!r}"]
    if isinstance(expected, dict):
        if list(expected) != list(actual):
            return [f"{where}: expected the keys {list(expected)}, read {list(actual)}"]
        return [d for key in expected for d in differences(expected[key], actual[key], f"{where}.{key}")]
    if isinstance(expected, list):
        if len(expected) != len(actual):
            return [f"{where}: expected {len(expected)} elements, read {len(actual)}"]
        return [d for i, (e, a) in enumerate(zip(expected, actual)) for d in differences(e, a, f"{where}[{i}]")]
    return [] if expected == actual else [f"{where}: expected {expected!r}, read {actual!r}"]


def check_golden():
    files = sorted(GOLDEN.glob("*.cbor"))
    if not files:
        sys.exit(f"no golden vectors in {GOLDEN}")
    wrong = 0
    for file in files:
        expected = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))["message"]
        for line in differences(expected, decode(file.read_bytes()), file.stem):
            print(line)
            wrong += 1
    print(f"{len(files)} golden vectors read with cbor2, {wrong} differences")
    return 1 if wrong else 0


def subscribe(broker, topic, count):
    try:
        import paho.mqtt.client as mqtt
    except ImportError:
        sys.exit("--broker needs paho-mqtt: pip install paho-mqtt")
    host, _, port = broker.partition(":")
    left = [count]

    def on_connect(client, _data, _flags, code, *_rest):
        if str(code) not in ("0", "Success"):
            sys.exit(f"{broker} refused: {code}")
        client.subscribe(topic)

    def on_message(client, _data, packet):
        parts = packet.topic.split("/")  # u2sa/<systemId>/<channel>/<TypeChain…>
        try:
            text = json.dumps(decode(packet.payload), ensure_ascii=False, default=as_json)
        except ValueError as e:
            text = f"{len(packet.payload)} bytes are no message: {e}"
        print(f"{'/'.join(parts[1:3])} {parts[-1]} {text}", flush=True)
        left[0] -= 1
        if left[0] == 0:
            client.disconnect()

    version2 = getattr(mqtt, "CallbackAPIVersion", None)
    client = mqtt.Client(version2.VERSION2) if version2 else mqtt.Client()
    client.on_connect = on_connect
    client.on_message = on_message
    try:
        client.connect(host, int(port or 1883))
    except (OSError, ValueError) as e:
        sys.exit(f"no broker at {broker}: {e}")
    client.loop_forever()
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--file", type=pathlib.Path, help="print the message in a file")
    parser.add_argument("--broker", metavar="HOST[:PORT]", help="print what an MQTT broker carries")
    parser.add_argument("--topic", default="u2sa/#", help="topic filter for --broker (default: %(default)s)")
    parser.add_argument("--count", type=int, default=-1, help="end after so many messages")
    arguments = parser.parse_args()
    if arguments.file:
        try:
            print(json.dumps(decode(arguments.file.read_bytes()), indent=2, ensure_ascii=False, default=as_json))
        except (OSError, ValueError) as e:
            sys.exit(f"{arguments.file}: {e}")
        return 0
    if arguments.broker:
        return subscribe(arguments.broker, arguments.topic, arguments.count)
    return check_golden()


if __name__ == "__main__":
    sys.exit(main())
