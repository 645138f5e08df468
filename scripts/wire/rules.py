"""What docs/wire-protocol.md and docs/schema/u2sa-messages.json say of one message on a broker. Knows nothing else of U2SA."""
import io
import math
import pathlib
import re
import sys

import cbor2

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(REPOSITORY / "clients" / "python" / "tools"))
import tables  # noqa: E402  (reads the schema)
from decode import ROW_MAJOR, as_list, named  # noqa: E402

_SCHEMA = tables.schema()
CHANNELS = {row["name"]: tables.channel(row)[1:] for row in _SCHEMA["channels"]}
MESSAGES = {row["name"]: tables.message(row) for row in _SCHEMA["messages"]}
CARRIED = {row["name"]: row["types"] for row in _SCHEMA["channels"]}
STANDARD = tuple(tuple(row["name"] for row in tables.standard(_SCHEMA[part])) for part in ("channels", "messages"))
CHECKED = set()  # classes of which a message was held to its table
WILL = "ConnectionLost"
_FLOAT64 = 86  # typed array, little endian: the only one that writers write
_SYSTEM_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,63}")
_FRAME = re.compile(r"GLOBAL|LOCAL_ENU|LOCAL_NED|BODY|BODY_FRD|BODY_FLU|UTM ([1-9]|[1-5][0-9]|60)[NS]")


class Difference(Exception):
    """Something that the page does not say."""


def require(holds, what):
    if not holds:
        raise Difference(what)


def split(topic):
    """System ID, channel, type chain and source. :raises Difference: if it is no topic of the page"""
    levels = topic.split("/")
    source = levels.pop()[1:] if len(levels) > 4 and levels[-1].startswith("=") else None
    require(len(levels) >= 4 and levels[0] == "u2sa" and "" not in levels, "topic is not u2sa/<systemId>/<channel>/<TypeChain>")
    require(_SYSTEM_ID.fullmatch(levels[1]), f"{levels[1]} is no system ID")
    require(levels[2] in CHANNELS, f"channel {levels[2]} is not in the table")
    return levels[1], levels[2], levels[3:], source


def check(topic, qos, payload, now_s):
    """Raises Difference if the message is not what the page says; returns its pairs and its origin (None without one).

    :param now_s: when it came in [s since 1970]
    """
    system, channel, chain, source = split(topic)
    carried = CARRIED[channel]
    require(any(name in carried for name in chain), f"{'/'.join(chain)} is none of {carried}")
    expected = 1 if WILL in chain else CHANNELS[channel][0]
    require(qos == expected, f"QoS {qos}, the page says {expected}")
    message, origin = parts(payload)
    require(message.get("systemId") == system, "systemId is not the topic's")
    if WILL in chain:
        require("timestamp" not in message, "a will has no timestamp")
        require((message.get("status"), message.get("lastError")) == ("FAILED", "connection lost"), "not as wills are")
        require("instance" in message, "a will without instance")
    else:
        require(0 < message.get("timestamp", 0) <= (now_s + 2.0) * 1e6, "no timestamp, or one in the future")
    fields_of(chain, message, "")
    field = CHANNELS[channel][2]
    written = re.sub("[/+#% .*>\x00-\x1f\x7f-\x9f]", lambda found: f"%{ord(found[0]):04X}", message.get(field) or "")
    require(source == (written or None), f"source {source}, expected {written or None}")
    return message, origin


class Typed(list):
    """A list that was written as a typed array, as only lists of this kind are."""

    def __init__(self, tag, kind):
        super().__init__(as_list(tag))
        self.kind = kind


def typed(tag):
    """The list that a writer wrote as this tag; that its lengths are in their shortest form is known."""
    if tag.tag == _FLOAT64:
        _floats(tag, 1)
        return Typed(tag, "numbers")
    require(tag.tag == ROW_MAJOR, f"tag {tag.tag} is none that writers write")
    require(isinstance(tag.value, (list, tuple)) and len(tag.value) == 2, "points are not dimensions and numbers")
    dimensions, numbers = tag.value
    expected = [_floats(numbers, 3), 3]
    require(cbor2.dumps(dimensions) == cbor2.dumps(expected), f"dimensions {dimensions}, expected {expected}")
    return Typed(tag, "points")


def _floats(value, together):
    """How many times so many float64 there are together."""
    require(isinstance(value, cbor2.CBORTag) and value.tag == _FLOAT64 and isinstance(value.value, bytes)
            and len(value.value) % (8 * together) == 0, f"no tag {_FLOAT64} on a byte string of float64, {together} together")
    return len(value.value) // (8 * together)


def parts(payload):
    """The message's pairs and its origin. Lists that were written as typed arrays are Typed."""
    stream = io.BytesIO(payload)
    message = cbor2.CBORDecoder(stream).decode()
    require(stream.read() == b"", "bytes after the message")
    require(isinstance(message, dict), "payload is no map")
    require(cbor2.dumps(message) == payload, "not as writers write: definite lengths, shortest integers, float64")
    message = named(message, typed)
    if "origin" not in message:
        return message, None
    require(list(message)[-1] == "origin", "origin is not behind all other pairs")
    sender, number = message.pop("origin")
    require(isinstance(sender, str) and 1 <= len(sender) <= 64 and type(number) is int and number >= 1,
            "origin is no sender and number")
    return message, (sender, number)


def fields_of(chain, message, where):
    known = [name for name in chain if name in MESSAGES]
    require(known, f"{where}no class of {chain} is in the tables")
    own, abstract, fields = MESSAGES[known[-1]]
    require(list(own) == chain[:len(own)], f"{where}chain {chain} is not {own}")
    newer = len(chain) > len(own)
    require(newer or not abstract, f"{where}{own[-1]} is abstract")
    keys = list(message)
    names = [field[0] for field in fields]
    present = [key for key in keys if key in names]
    require(newer or len(present) == len(keys), f"{where}keys that no table has: {set(keys) - set(names)}")
    require(present == [name for name in names if name in message], f"{where}keys are not in the table's order: {keys}")
    for name, kind, presence, _default, least, most, choices, _since, longest, _shortens in fields:
        require(name in message or presence == "optional", f"{where}{name} is {presence} and missing")
        if name in message:
            value_of(kind, message[name], least, most, choices, f"{where}{name}: ")
            texts_are_within(longest, message[name], f"{where}{name}: ")
    quantities(message, where)
    CHECKED.update(chain)


def texts_are_within(longest, value, where):
    """Names, identifiers and notes, counted in UTF-16 code units."""
    for text in ([value] if isinstance(value, str) else value) if longest is not None else ():
        length = len(text.encode("utf-16-le")) // 2
        require(length <= longest, f"{where}{length} characters are more than {longest}")


def quantities(message, where):
    """What units and frames say beyond the tables' ranges."""
    frame = message.get("referenceFrame", "")
    for name, most in (("x", 180.0), ("y", 90.0)) if frame == "GLOBAL" else ():
        require(abs(message.get(name, 0.0)) <= most, f"{where}{name} is {message.get(name)} deg in GLOBAL")
    if frame and not frame.startswith("BODY") and "psi" in message:
        require(0.0 <= message["psi"] <= 2 * math.pi, f"{where}psi is {message['psi']} rad in {frame}")
    for name, value in message.items():
        require(not name.endswith("Sigma") or value >= 0.0, f"{where}{name} is {value}")


def value_of(kind, value, least, most, choices, where):
    def is_number(item):
        return type(item) is float and math.isfinite(item)

    if kind == "float64":
        require(is_number(value), f"{where}{value!r} is no finite float64")
        require(least is None or value >= least, f"{where}{value} is less than {least}")
        require(most is None or value <= most, f"{where}{value} is more than {most}")
    elif kind == "int":
        require(type(value) is int and -(1 << 63) <= value < 1 << 63, f"{where}{value!r} is no int")
    elif kind == "bool":
        require(type(value) is bool, f"{where}{value!r} is no bool")
    elif kind == "enum":
        require(value in choices, f"{where}{value!r} is none of {choices}")
    elif kind == "frame":
        require(type(value) is str and _FRAME.fullmatch(value), f"{where}{value!r} is no frame")
    elif kind == "text":
        require(type(value) is str and len(value.encode()) <= 65536, f"{where}{value!r} is no text")
    elif kind == "bytes":
        require(type(value) is bytes and len(value) <= 983040, f"{where}{value!r} is no byte string")
    elif kind == "point":
        require(type(value) is list and len(value) == 3 and all(map(is_number, value)), f"{where}{value!r} is no point")
    else:
        require(type(value) is list or type(value) is Typed and value.kind == kind, f"{where}{value!r} is no array of {kind}")
        require(len(value) <= 100_000, f"{where}{len(value)} elements are too many")
        for index, item in enumerate(value):
            element(kind, item, f"{where[:-2]}[{index}]: ")


ELEMENTS = {"texts": "text", "numbers": "float64", "flags": "bool", "points": "point"}


def element(kind, item, where):
    if kind in ELEMENTS:
        value_of(ELEMENTS[kind], item, None, None, (), where)
    else:
        require(type(item) is dict and next(iter(item), None) == "type", f"{where}does not open with its type chain")
        chain = item.pop("type")
        require(kind.partition(":")[2] in chain, f"{where}{chain} is no {kind.partition(':')[2]}")
        fields_of(chain, item, where)
