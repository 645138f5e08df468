"""Messages that wait for a service."""
from __future__ import annotations

import collections
import threading
import time
from typing import Deque, Dict, List, Optional, Tuple

from .message import Message

Delivery = Tuple[str, Message]

_URGENT = "emergency-stop"
_RESERVED = ("arming", "arming-state", "failsafe")
_MAX_BYTES = 16 << 20  # as received, of waiting messages; in memory they take several times that

#: Channels of which only a source's newest message counts, and the fields that name the source.
LATEST: Dict[str, Tuple[str, ...]] = {
    "sensed-state": ("sensorName",),
    "state": ("sensorName",),
    "local-state": ("sensorName",),
    "scans": ("sensorName",),
    "images": ("sensorName",),
    "objects": (),
    "grid": (),
    "goals": (),
    "navigation": ("subsystem",),
    "plans": ("subsystem",),
    "actuation": ("actuatorName",),
    "actuators": ("actuatorName",),
    "health": ("serviceName",),
    "conditions": ("serviceName",),
    "failsafe": (),
    "operator": ("operator",),
    "arming-state": (),
    "power": ("sensorName",),
}


class Inbox:
    """Any thread puts, the service's thread takes.

    Emergency stops overtake all others. On latest channels a message replaces the waiting one of the same source, in its
    place. Arming and failsafes wait among the others, but the others cannot take their room (docs/service-contract.md).

    :param capacity: messages that wait at most, and as many emergency stops and reserved ones each
    :param max_bytes: bytes that the others have at most, as received
    """

    def __init__(self, capacity: int, max_bytes: int = _MAX_BYTES) -> None:
        self._capacity = capacity
        self._max_bytes = max_bytes
        self._bytes = 0
        self._some = threading.Condition()
        self._urgent: Deque[List[Delivery]] = collections.deque()
        self._others: Deque[List[Delivery]] = collections.deque()  # a list of one: what waits can be replaced
        self._newest: Dict[Tuple[object, ...], List[Delivery]] = {}
        self._reserved = 0  # in _others
        self._woken = False

    def put(self, channel: str, message: Message) -> str:
        """Takes a message. Returns "replaced" or "dropped" if one was; else an empty text."""
        with self._some:
            key = _key(channel, message)
            waiting = self._newest.get(key) if key is not None else None
            if waiting is not None:
                more = message.received_bytes - waiting[0][1].received_bytes
                if self._is_too_much(channel, more):
                    return "dropped"
                self._bytes += more
                waiting[0] = (channel, message)
                return "replaced"
            if self._is_full(channel) or self._is_too_much(channel, message.received_bytes):
                return "dropped"
            self._bytes += message.received_bytes
            place = [(channel, message)]
            (self._urgent if channel == _URGENT else self._others).append(place)
            self._reserved += channel in _RESERVED
            if key is not None:
                self._newest[key] = place
            self._some.notify()
            return ""

    def _is_full(self, channel: str) -> bool:
        if channel == _URGENT:
            return len(self._urgent) >= self._capacity
        if channel in _RESERVED:
            return self._reserved >= self._capacity
        return len(self._others) - self._reserved >= self._capacity

    def _is_too_much(self, channel: str, more: int) -> bool:
        return channel != _URGENT and channel not in _RESERVED and more > 0 and self._bytes + more > self._max_bytes

    def take(self, within_s: float) -> Optional[Delivery]:
        """The oldest message, emergency stops first; None if none comes within this time or `wake` is called."""
        until = time.monotonic() + within_s
        with self._some:
            while not self._urgent and not self._others and not self._woken:
                left = until - time.monotonic()
                if left <= 0.0:
                    return None
                self._some.wait(left)
            self._woken = False
            line = self._urgent or self._others
            if not line:
                return None
            channel, message = line.popleft()[0]
            self._reserved -= channel in _RESERVED
            self._bytes -= message.received_bytes
            self._newest.pop(_key(channel, message) or (), None)
            return channel, message

    def wake(self) -> None:
        """Makes `take` return at once."""
        with self._some:
            self._woken = True
            self._some.notify()

    def depth(self) -> int:
        """How many messages wait."""
        with self._some:
            return len(self._urgent) + len(self._others)


def _key(channel: str, message: Message) -> Optional[Tuple[object, ...]]:
    """What a newer message replaces; None on channels on which each matters."""
    fields = LATEST.get(channel)
    if fields is None:
        return None
    # What others say about a lost service does not replace what it said itself.
    about = ("threadAlive" in message,) if message.is_a("ConnectionLost") else ()
    return (channel, *(message.get(field) for field in fields), *about)
