"""Lists of numbers and of points as typed arrays (RFC 8746), which a reader takes like plain ones."""
from __future__ import annotations

from struct import Struct
from typing import Any, List, Optional, Sequence, Tuple

import cbor2

from .message import LIST_ELEMENTS, number, sequence
from .schema import Malformed

_ROW_MAJOR = 40  # a multi-dimensional array: its dimensions, and its elements row by row
_FLOATS = {80: ("float16", Struct(">e")), 81: ("float32", Struct(">f")), 82: ("float64", Struct(">d")),
           84: ("float16", Struct("<e")), 85: ("float32", Struct("<f")), 86: ("float64", Struct("<d"))}
_COORDINATES = 3


def numbers(value: Any, where: str) -> Any:
    """The numbers of a typed array; what has no tag as it is. Whether they are finite shows where they are set."""
    if not isinstance(value, cbor2.CBORTag):
        return value
    count = _count(value, where)
    if count > LIST_ELEMENTS:
        raise Malformed(f"{where}: expected at most {LIST_ELEMENTS} elements, not {count}")
    return _unpacked(value)


def points(value: Any, where: str) -> Any:
    """The points of a two-dimensional array; what has no tag as it is."""
    if not isinstance(value, cbor2.CBORTag):
        return value
    if value.tag != _ROW_MAJOR:
        raise Malformed(f"{where}: expected an array of points or tag {_ROW_MAJOR}, not tag {value.tag}")
    return _rows(value, _COORDINATES, where)


def plain(value: cbor2.CBORTag, where: str) -> Any:
    """The list that a typed or two-dimensional array of floats stands for; what has another tag as it is."""
    if value.tag == _ROW_MAJOR:
        return _rows(value, None, where)
    return numbers(value, where) if value.tag in _FLOATS else value


def _rows(array: cbor2.CBORTag, width: Optional[int], where: str) -> List[Sequence[float]]:
    """:param width: how many numbers a row has; None: any number from 1"""
    parts = array.value
    if not isinstance(parts, (list, tuple)) or len(parts) != 2:  # within tags cbor2 6 makes tuples, 5 makes lists
        raise Malformed(f"{where}: expected an array of dimensions and numbers behind tag {_ROW_MAJOR}")
    rows, columns = _dimensions(parts[0], width, where)
    data = parts[1]
    typed = isinstance(data, cbor2.CBORTag)
    count = _count(data, where) if typed else len(sequence(data, where))
    if count != rows * columns:
        raise Malformed(f"{where}: expected {rows} times {columns} numbers, not {count}")
    flat = _unpacked(data) if typed else [number(item, where) for item in data]
    return [flat[begin:begin + columns] for begin in range(0, count, columns)]


def _dimensions(value: Any, width: Optional[int], where: str) -> Tuple[int, int]:
    if (not isinstance(value, (list, tuple)) or len(value) != 2 or not all(type(size) is int for size in value)
            or not 0 <= value[0] <= LIST_ELEMENTS
            or not (1 <= value[1] <= LIST_ELEMENTS if width is None else value[1] == width)):
        raise Malformed(f"{where}: expected the dimensions [n, {width or 'm'}] of at most {LIST_ELEMENTS} elements, "
                        f"not {value!r}")
    return value[0], value[1]


def _count(array: cbor2.CBORTag, where: str) -> int:
    """How many floats are in the bytes: told before memory is taken for them."""
    if array.tag not in _FLOATS:
        raise Malformed(f"{where}: expected an array, or a typed array of float16, 32 or 64, not tag {array.tag}")
    name, form = _FLOATS[array.tag]
    if not isinstance(array.value, bytes) or len(array.value) % form.size != 0:
        was = f"{len(array.value)} bytes" if isinstance(array.value, bytes) else type(array.value).__name__
        raise Malformed(f"{where}: expected a byte string of whole {name}, not {was}")
    return len(array.value) // form.size


def _unpacked(array: cbor2.CBORTag) -> List[float]:
    _name, form = _FLOATS[array.tag]
    return [item for item, in form.iter_unpack(array.value)]
