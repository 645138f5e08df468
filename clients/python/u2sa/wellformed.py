"""Looks CBOR through before memory is taken for it: lengths, depth, keys that come twice, which cbor2 lets pass, and
tags, of which it obeys some, in each version others."""
from __future__ import annotations

from typing import Set, Union

from .schema import Malformed

DEPTH = 8
_UNSIGNED, _BYTES, _TEXT, _ARRAY, _MAP, _TAG, _SIMPLE = 0, 2, 3, 4, 5, 6, 7
_ARRAY_TAGS = frozenset((40, 1040, *range(64, 88)))  # RFC 8746, but 41, whose arrays are like any; cbor2 obeys none
_INDEFINITE = 31
_BREAK = 0xFF
_LIST_ELEMENTS = 100_000
_MAX_BYTES = {_BYTES: 1 << 20, _TEXT: 1 << 16}  # of a byte string that a field takes: message.BYTE_STRING_BYTES


def untagged(payload: bytes) -> bytes:
    """The item without its tags, but for those of arrays: a reader skips a tag and reads the item behind it.

    :raises Malformed: unless the bytes are one well-formed item of at most 8 levels and nothing after it
    """
    scan = _Scan(payload)
    scan.item(0)
    if scan.at != len(payload):
        raise Malformed(f"byte {scan.at}: expected the end of the message, not more bytes")
    return scan.untagged()


class _Scan:
    def __init__(self, payload: bytes) -> None:
        self.bytes = payload
        self.at = 0
        self._kept = bytearray()  # what is before _passed, but for the tags that are skipped
        self._passed = 0

    def untagged(self) -> bytes:
        """The bytes without the tags that were skipped so far."""
        return bytes(self._kept + self.bytes[self._passed:]) if self._passed else self.bytes

    def item(self, depth: int) -> None:
        """Steps over one item."""
        begin = head = self.at
        major, info, length = self._head()
        tags = 0
        while major == _TAG:
            if length not in _ARRAY_TAGS:
                self._skip_tag(head)
            else:  # whether its item is one that a field takes shows later
                tags += 1
                if tags > DEPTH:
                    raise Malformed(f"byte {begin}: more than {DEPTH} array tags of one item")
            head = self.at
            major, info, length = self._head()
        if major in _MAX_BYTES:
            self._string(major, info, length)
        elif major == _ARRAY or major == _MAP:
            if depth == DEPTH:
                raise Malformed(f"byte {begin}: more than {DEPTH} levels")
            self._container(major, info, length, depth + 1)
        elif major == _SIMPLE and info == _INDEFINITE:
            raise Malformed(f"byte {begin}: a break where an item was expected")

    def _skip_tag(self, begin: int) -> None:
        self._kept += self.bytes[self._passed:begin]
        self._passed = self.at

    def _head(self) -> "tuple[int, int, int]":
        first = self._take(1)[0]
        major, info = first >> 5, first & 31
        if info < 24:
            return major, info, info
        if info < 28:
            return major, info, int.from_bytes(self._take(1 << (info - 24)), "big")
        if info == _INDEFINITE and major in (_UNSIGNED, _BYTES, _TEXT, _ARRAY, _MAP, _SIMPLE):
            return major, info, -1
        raise Malformed(f"byte {self.at - 1}: {first:#04x} begins no item")

    def _take(self, count: int) -> bytes:
        if count > len(self.bytes) - self.at:
            raise Malformed(f"byte {self.at}: cut short")
        self.at += count
        return self.bytes[self.at - count:self.at]

    def _string(self, major: int, info: int, length: int) -> None:
        most = _MAX_BYTES[major]
        if info != _INDEFINITE:
            self._take(self._bounded(length, most))
            return
        total = 0
        while not self._at_break():
            chunk, chunk_info, chunk_length = self._head()
            if chunk != major or chunk_info == _INDEFINITE:
                raise Malformed(f"byte {self.at}: expected a chunk of the same string")
            total = self._bounded(total + chunk_length, most)
            self._take(chunk_length)

    def _container(self, major: int, info: int, length: int, depth: int) -> None:
        keys: Set[Union[bytes, int]] = set()
        count = 0
        while not self._at_break() if info == _INDEFINITE else count < length:
            count = self._bounded(count + 1, _LIST_ELEMENTS)
            if major == _MAP:
                begin = self.at
                major_of_key = self.bytes[begin] >> 5 if begin < len(self.bytes) else _TEXT
                if major_of_key != _TEXT and major_of_key != _UNSIGNED:
                    raise Malformed(f"byte {begin}: expected a text key or a label")
                self.item(depth)
                item = self.bytes[begin:self.at]
                key = _text(item) if major_of_key == _TEXT else _label(item)
                if key in keys:
                    raise Malformed(f"byte {begin}: the key comes twice")
                keys.add(key)
            self.item(depth)

    def _at_break(self) -> bool:
        if self.at < len(self.bytes) and self.bytes[self.at] == _BREAK:
            self.at += 1
            return True
        return False

    def _bounded(self, count: int, most: int) -> int:
        if count > most:
            raise Malformed(f"byte {self.at}: expected at most {most}, not {count}")
        return count


def _label(item: bytes) -> int:
    """The number of a label, however it is written."""
    return _Scan(item)._head()[2]


def _text(item: bytes) -> bytes:
    """The UTF-8 of a text item, however its length is written."""
    scan = _Scan(item)
    _major, info, _length = scan._head()
    if info != _INDEFINITE:
        return item[scan.at:]
    parts = []
    while not scan._at_break():
        _chunk, _info, length = scan._head()
        parts.append(scan._take(length))
    return b"".join(parts)
