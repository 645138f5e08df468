"""One message: fields by name, checked against the tables as they are set."""
from __future__ import annotations

import math
import re
from typing import Any, Dict, Iterator, Optional, Sequence, Tuple

from . import texts
from .schema import STANDARD, Field, Malformed, MessageType, Schema

TEXT_BYTES = 1 << 16
BYTE_STRING_BYTES = 15 << 16
LIST_ELEMENTS = 100_000
_FRAME = re.compile(r"GLOBAL|LOCAL_ENU|LOCAL_NED|BODY|BODY_FRD|BODY_FLU|UTM ([1-9]|[1-5][0-9]|60)[NS]")


class Message:
    """A message of one class.

    >>> state = Message("StateInformation", sensorName="Compass", psi=1.57)
    >>> state["psi"], state.get("x"), "x" in state
    (1.57, None, False)

    Numbers are SI units and radians, in GLOBAL x and y degrees; which field has which is in docs/wire-protocol.md.
    A message read from the wire may be of a class that this reader does not know: then `type` is the nearest known
    ancestor (None if there is none), `chain` its own, and `unknown` the fields beyond the ancestor's.
    """

    def __init__(self, name: str, /, schema: Schema = STANDARD, **fields: Any) -> None:
        kind = schema.type(name)
        if kind.abstract:
            raise ValueError(f"{name} is abstract: only subclasses travel")
        self._start(kind, kind.chain)
        for key, value in fields.items():
            self[key] = value

    def _start(self, kind: Optional[MessageType], chain: Sequence[str]) -> None:
        self.type = kind
        self.chain: Tuple[str, ...] = tuple(chain)
        self.unknown: Dict[str, Any] = {}
        self.origin: Optional[Tuple[str, int]] = None  # who sent it, and which of its messages on the topic it is
        self.received_bytes = 0  # that it was read from; 0 if it was made here
        self._values: Dict[str, Any] = {}

    @classmethod
    def carrier(cls, kind: Optional[MessageType], chain: Sequence[str]) -> "Message":
        """An empty message of a chain of which `kind` is the nearest known class; for readers."""
        message = cls.__new__(cls)
        message._start(kind, chain)
        return message

    @property
    def name(self) -> str:
        """The message's own class, the last of its chain."""
        return self.chain[-1]

    def is_a(self, name: str) -> bool:
        """Whether it is of that class or a subclass."""
        return name in self.chain

    def __setitem__(self, key: str, value: Any) -> None:
        field = self._field(key)
        self._values[key] = checked(field, value, f"{self.name}.{key}")

    def __getitem__(self, key: str) -> Any:
        value = self.get(key)
        if value is None:
            raise KeyError(f"{self.name}.{key} is not set")
        return value

    def get(self, key: str, otherwise: Any = None) -> Any:
        """The value, else the field's default, else `otherwise`."""
        if key in self.unknown:
            return self.unknown[key]
        if self.type is None:
            return otherwise
        field = self._field(key)
        value = self._values.get(key, field.default)
        return otherwise if value is None else value

    def __contains__(self, key: str) -> bool:
        return key in self._values or key in self.unknown

    def _field(self, key: str) -> Field:
        field = self.type.field(key) if self.type else None
        if field is None:
            raise KeyError(f'{self.name} has no field "{key}"')
        return field

    def items(self) -> Iterator[Tuple[str, Any]]:
        """Name and value of what is written, in the order of the wire."""
        for field in self.type.fields if self.type else ():
            value = self._values.get(field.name, field.default)
            if value is not None:
                yield field.name, value
        yield from self.unknown.items()

    def missing(self) -> Optional[str]:
        """The first required field that is not set; None if the message is complete."""
        fields = self.type.fields if self.type else ()
        return next((field.name for field in fields if field.required and field.name not in self._values), None)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Message) and self.chain == other.chain and list(self.items()) == list(other.items())

    def __hash__(self) -> int:
        return hash(self.chain)

    def __repr__(self) -> str:
        return self.name + "{" + ", ".join(f"{key}={value!r}" for key, value in self.items()) + "}"


def checked(field: Field, value: Any, where: str) -> Any:
    """The value as the field holds it. :raises Malformed: naming the field, the value and what was expected"""
    kind = field.kind
    if kind == "float64":
        return number(value, where, field.least, field.most)
    if kind == "int":
        if isinstance(value, bool) or not isinstance(value, int) or not -(1 << 63) <= value < 1 << 63:
            raise Malformed(f"{where}: expected an integer of 64 bits, not {value!r}")
        return value
    if kind == "bool":
        return flag(value, where)
    if kind == "bytes":
        return byte_string(value, where)
    if kind == "enum" and text(value, where) not in field.choices:
        raise UnknownConstant(f"{where}: expected one of {', '.join(field.choices)}, not {value!r}")
    if kind == "frame" and not _FRAME.fullmatch(text(value, where)):
        raise Malformed(f"{where}: expected a reference frame, not {value!r}")
    if kind in ("enum", "frame"):
        return text(value, where)
    if kind == "text":
        return bounded_text(field, value, where)
    if kind == "point":
        return point(value, where)
    items = sequence(value, where)
    if kind == "texts":
        if field.shortens:
            return texts.shortened_list(field.longest, [string(item, where) for item in items])
        return tuple(bounded_text(field, item, where) for item in items)
    if kind == "numbers":
        return tuple(number(item, where) for item in items)
    if kind == "flags":
        return tuple(flag(item, where) for item in items)
    if kind == "points":
        return tuple(point(item, where) for item in items)
    element = kind.partition(":")[2]
    for item in items:
        if not isinstance(item, Message) or not item.is_a(element):
            raise Malformed(f"{where}: expected a list of {element} messages, not {item!r}")
    return tuple(items)


class UnknownConstant(Malformed):
    """A constant of an enum that this reader does not know."""


def flag(value: Any, where: str) -> bool:
    """True or false."""
    if not isinstance(value, bool):
        raise Malformed(f"{where}: expected true or false, not {value!r}")
    return value


def number(value: Any, where: str, least: Optional[float] = None, most: Optional[float] = None) -> float:
    """A finite float within its range."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Malformed(f"{where}: expected a number, not {value!r}")
    try:
        as_float = float(value)
    except OverflowError:
        raise Malformed(f"{where}: expected a number that float64 can hold, not a larger one") from None
    if not math.isfinite(as_float):
        raise Malformed(f"{where}: expected a finite number, not {value!r}")
    if (least is not None and as_float < least) or (most is not None and as_float > most):
        raise Malformed(f"{where}: expected {least}…{'∞' if most is None else most}, not {value!r}")
    return as_float


def bounded_text(field: Field, value: Any, where: str) -> str:
    """Text as the field takes it: a name or identifier that is not too long, a note shortened."""
    if field.shortens:
        return texts.shortened(field.longest, string(value, where))
    whole = text(value, where)
    return whole if field.longest is None else texts.refused_beyond(field.longest, whole, where)


def string(value: Any, where: str) -> str:
    """Text of any length."""
    if not isinstance(value, str):
        raise Malformed(f"{where}: expected text, not {value!r}")
    return value


def text(value: Any, where: str) -> str:
    """Unicode text of at most 64 KiB of UTF-8."""
    string(value, where)
    try:
        if len(value.encode("utf-8")) > TEXT_BYTES:
            raise Malformed(f"{where}: expected at most {TEXT_BYTES} bytes of text")
    except UnicodeEncodeError as e:
        raise Malformed(f"{where}: expected Unicode text: {e}") from e
    return value


def byte_string(value: Any, where: str) -> bytes:
    """At most 960 KiB of bytes."""
    if not isinstance(value, (bytes, bytearray)):
        raise Malformed(f"{where}: expected a byte string, not {value!r}")
    if len(value) > BYTE_STRING_BYTES:
        raise Malformed(f"{where}: expected at most {BYTE_STRING_BYTES} bytes in a byte string, not {len(value)}")
    return bytes(value)


def point(value: Any, where: str) -> Tuple[float, float, float]:
    """x, y, z."""
    coordinates = sequence(value, where)
    if len(coordinates) != 3:
        raise Malformed(f"{where}: expected a point of three numbers, not of {len(coordinates)}")
    return (number(coordinates[0], where), number(coordinates[1], where), number(coordinates[2], where))


def sequence(value: Any, where: str) -> Sequence[Any]:
    """A list of at most 100 000 elements."""
    if not isinstance(value, (list, tuple)):
        raise Malformed(f"{where}: expected an array, not {value!r}")
    if len(value) > LIST_ELEMENTS:
        raise Malformed(f"{where}: expected at most {LIST_ELEMENTS} elements")
    return value
