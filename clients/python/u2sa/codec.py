"""Messages as CBOR (docs/wire-protocol.md, Payload)."""
from __future__ import annotations

import hashlib
from typing import Any, Dict, List, Optional, Sequence, Tuple

import cbor2

from . import message as values
from . import typed
from .message import Message, UnknownConstant
from .schema import STANDARD, TYPE_KEY, Malformed, Schema, name_of
from .wellformed import untagged

PAYLOAD_BYTES = 1 << 20
CHAIN_NAMES = 8
_ORIGIN = "origin"


def encode(message: Message, origin: Optional[Tuple[str, int]] = None) -> bytes:
    """The message's bytes: equal messages have equal ones.

    :param origin: the sender, and which of its messages on the topic this is, from 1

    :raises ValueError: if a required field is missing or the bytes exceed 1 MiB
    """
    pairs = _map(message, within_list=False)
    if origin is not None:
        pairs[_ORIGIN] = list(origin)
    payload: bytes = cbor2.dumps(pairs)
    if len(payload) > PAYLOAD_BYTES:
        raise ValueError(f"{message.name}: {len(payload)} bytes exceed the {PAYLOAD_BYTES} that readers take")
    return payload


def identity(order: Message) -> Optional[bytes]:
    """What an order that a broker delivers twice has in common with its repeat: ID, timestamp and content.

    None without ID and timestamp: nobody can tell a repeat from an order given again.
    """
    given = dict(order.items())
    if not given.get("requestId") and given.get("timestamp") is None:
        return None
    return hashlib.sha256(encode(order)).digest()


def _map(message: Message, within_list: bool) -> Dict[str, Any]:
    missing = message.missing()
    if missing is not None:
        raise ValueError(f"{message.name}.{missing} is required and was never set")
    pairs: Dict[str, Any] = {TYPE_KEY: list(message.chain)} if within_list else {}
    for key, value in message.items():
        pairs[key] = _value(value)
    return pairs


def _value(value: Any) -> Any:
    if isinstance(value, Message):
        return _map(value, within_list=True)
    if isinstance(value, (list, tuple)):
        return [_value(item) for item in value]
    return value


def decode(chain: Sequence[str], payload: bytes, schema: Schema = STANDARD) -> Message:
    """The message in the bytes. Unknown keys are skipped; a class that is unknown is read as its nearest known
    ancestor and keeps what it has beyond that one.

    :param chain: from the topic, eldest ancestor first
    :raises Malformed: for whatever is wrong with chain or bytes
    """
    _check_chain(chain)
    if len(payload) > PAYLOAD_BYTES:
        raise Malformed(f"expected at most {PAYLOAD_BYTES} bytes, not {len(payload)}")
    items = untagged(payload)
    try:
        pairs = cbor2.loads(items)
    except Exception as e:  # what cbor2 raises differs by its version
        raise Malformed(f"{chain[-1]}: no CBOR: {e}") from e
    named = _named(pairs, chain[-1])
    origin = named.pop(_ORIGIN, None)
    message = _message(chain, named, schema, chain[-1])
    message.origin = _origin(origin)
    message.received_bytes = len(payload)
    return message


def _origin(value: Any) -> Optional[Tuple[str, int]]:
    if value is None:
        return None
    if (not isinstance(value, list) or len(value) != 2 or not isinstance(value[0], str) or not 1 <= len(value[0]) <= 64
            or type(value[1]) is not int or not 1 <= value[1] < 1 << 63):
        raise Malformed(f"origin: expected the sender and a number from 1 of 64 bits, not {value!r}")
    return value[0], value[1]


def _check_chain(chain: Sequence[str]) -> None:
    if not 1 <= len(chain) <= CHAIN_NAMES or not all(isinstance(name, str) and name for name in chain):
        raise Malformed(f"expected 1…{CHAIN_NAMES} type names, not {list(chain)!r}")


def _named(pairs: Any, where: str) -> Dict[str, Any]:
    """The pairs of a map by the names of their fields, whether those or their labels were written."""
    if not isinstance(pairs, dict):
        raise Malformed(f"{where}: expected a map, not {type(pairs).__name__}")
    named: Dict[str, Any] = {}
    for key, value in pairs.items():
        if type(key) is int and key >= 0 or isinstance(key, str):
            name = name_of(key)
        else:
            raise Malformed(f"{where}: expected a text key or a label, not {key!r}")
        if name in named:
            raise Malformed(f"{where}.{name}: the key comes twice")
        named[name] = value
    return named


def _message(chain: Sequence[str], pairs: Dict[str, Any], schema: Schema, where: str) -> Message:
    kind = schema.nearest(chain)
    message = Message.carrier(kind, chain)
    known = kind is not None and kind.chain == tuple(chain)
    for key, value in pairs.items():
        field = kind.field(key) if kind else None
        if field is None:
            if not known and key != TYPE_KEY:
                message.unknown[key] = _plain(value, f"{where}.{key}")
            continue
        if field.kind.startswith("messages:"):
            value = _nested(value, schema, f"{where}.{key}")
        elif field.kind == "numbers":
            value = typed.numbers(value, f"{where}.{key}")
        elif field.kind == "points":
            value = typed.points(value, f"{where}.{key}")
        try:
            message[key] = value
        except UnknownConstant:
            if field.presence != "optional":
                raise
    missing = message.missing()
    if missing is not None:
        raise Malformed(f"{where}.{missing} is required and missing")
    return message


def _nested(value: Any, schema: Schema, where: str) -> List[Message]:
    messages = []
    for element in values.sequence(value, where):
        pairs = _named(element, where)
        if next(iter(pairs), None) != TYPE_KEY:
            raise Malformed(f'{where}: expected "type" as the first key of a message in a list')
        chain = pairs[TYPE_KEY]
        if not isinstance(chain, list):
            raise Malformed(f"{where}.type: expected an array, not {chain!r}")
        _check_chain(chain)
        messages.append(_message(chain, pairs, schema, where))
    return messages


def _plain(value: Any, where: str) -> Any:
    """A value of a field that no table has: numbers, texts, byte strings, flags, arrays and maps of such."""
    if isinstance(value, cbor2.CBORTag):
        value = typed.plain(value, where)
    if isinstance(value, dict):
        return {values.text(key, where): _plain(item, where) for key, item in _named(value, where).items()}
    if isinstance(value, list):
        return [_plain(item, where) for item in values.sequence(value, where)]
    if isinstance(value, str):
        return values.text(value, where)
    if isinstance(value, bytes):
        return values.byte_string(value, where)
    if isinstance(value, float):
        return values.number(value, where)
    if isinstance(value, bool) or (isinstance(value, int) and -(1 << 63) <= value < 1 << 63):
        return value
    raise Malformed(f"{where}: expected a number, text, bool, byte string, array or map, not {value!r}")
