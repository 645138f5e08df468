"""The emergency stop as an actuator remembers it."""
from __future__ import annotations

import time
from typing import Dict, List, Optional

from .message import Message


_TOLD_APART = 64  # stops that are told apart; of more, as a flood makes them, only the newest time is known


def _micros(stop: Message) -> int:
    return int(stop["timestamp"])


def _stamped(stop: Message) -> Message:
    copy = Message.carrier(stop.type, stop.chain)
    for key, value in stop.items():
        copy[key] = value
    copy["timestamp"] = time.time_ns() // 1000
    return copy


class EmergencyLatch:
    """Latched by each EmergencyStop with active for itself, lifted by one without that names it in `lifts`, or without
    names it or a newer one in `clears`.

    On the safe side: a stop of unknown origin or time latches too, a clear of another system lifts nothing. Belongs to
    one thread.

    :param system_id: whose clears count; None: everybody's
    """

    def __init__(self, system_id: Optional[str] = None) -> None:
        self._system_id = system_id
        self._standing: Dict[str, Message] = {}  # by identity, in order of arrival; each with a timestamp
        self._beyond: Optional[Message] = None  # the newest of those that are not told apart
        self._lifted: List[str] = []  # identities, the oldest first

    @property
    def active(self) -> bool:
        """Whether a stop holds."""
        return bool(self._standing) or self._beyond is not None

    @property
    def stops(self) -> List[str]:
        """Which stops hold, as `emergencyStops` of a HealthReport lists them."""
        return list(self._standing)

    @property
    def newest(self) -> Optional[Message]:
        """The newest stop that holds, with the timestamp under which it is known; None if none holds."""
        held = [*self._standing.values(), *([] if self._beyond is None else [self._beyond])]
        return max(reversed(held), key=_micros) if held else None

    def take(self, stop: Message) -> bool:
        """Takes note of a message of the channel emergency-stop; returns whether everything must be neutral now.

        A repetition of a stop that was lifted, of one who has not heard of the clear, changes nothing.
        """
        if stop.get("active"):
            self._latch(stop)
        elif self._is_ours(stop):
            self._lift(stop.get("lifts", []), stop.get("clears", -1))
        return self.active

    def _latch(self, message: Message) -> None:
        stop = message if "timestamp" in message else _stamped(message)
        identity = stop.get("stopId") or "|".join(
            [stop.get("systemId", ""), str(_micros(stop)), stop.get("operator", ""), stop.get("reason", "")])
        if identity in self._lifted or identity in self._standing:
            return
        if len(self._standing) < _TOLD_APART:
            self._standing[identity] = stop
        elif self._beyond is None or _micros(stop) > _micros(self._beyond):
            self._beyond = stop

    def _lift(self, names: List[str], until: int) -> None:
        over = [each for each, stop in self._standing.items() if (each in names if names else _micros(stop) <= until)]
        for identity in over:
            del self._standing[identity]
        self._lifted = (self._lifted + over)[-2 * _TOLD_APART:]
        if self._beyond is not None and _micros(self._beyond) <= until:
            self._beyond = None

    def _is_ours(self, clear: Message) -> bool:
        return self._system_id is None or clear.get("systemId", self._system_id) == self._system_id
