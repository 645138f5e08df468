"""The emergency stop as an actuator remembers it."""
from __future__ import annotations

import time
from typing import Callable, Dict, List, Optional, Set, Tuple

from .clock import SystemTime
from .codec import identity
from .message import Message


_TOLD_APART = 64  # stops that are told apart; of more, as a flood makes them, only the newest time is known
_UNKNOWN_S = 0.5  # who clears other stops cannot have known one that arrived so shortly before
_REPEATED_S = 10.0  # how long after the clear a stop without a timestamp may repeat the lifted one


def _micros(stop: Message) -> int:
    return int(stop["timestamp"])


def _stamped(stop: Message, micros: int) -> Message:
    copy = Message.carrier(stop.type, stop.chain)
    for key, value in stop.items():
        copy[key] = value
    copy["timestamp"] = micros
    return copy


class EmergencyLatch:
    """Latched by each EmergencyStop with active for itself, lifted by one without that names it in `lifts`, or without
    names it or a newer one in `clears`.

    On the safe side: a stop of unknown origin or time latches too, so does one that reuses the ID of a lifted one, and a
    clear of another system lifts nothing, nor does one that arrives again: another stop may have been given since by a
    clock that is behind. Belongs to one thread.

    :param system_id: whose clears count; None: everybody's
    :param micros: the time for stops without one
    """

    def __init__(self, system_id: Optional[str] = None, micros: Callable[[], int] = SystemTime().micros) -> None:
        self._micros = micros
        self._system_id = system_id
        self._standing: Dict[str, Message] = {}  # by identity, in order of arrival; each with a timestamp
        self._arrived: Dict[str, Tuple[float, bool]] = {}  # of those standing: when, and whether it was given again
        self._beyond: Optional[Message] = None  # the newest of those that are not told apart
        self._untimed: Set[str] = set()  # those standing that had no timestamp of their own
        self._clears: Dict[bytes, None] = {}  # those that were heard; the oldest first
        self._lifted: Dict[str, Tuple[Optional[int], float]] = {}  # by identity: timestamp, if any, and when; the oldest first

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
        elif self._is_ours(stop) and self._is_new(stop):
            self._lift(stop.get("lifts", []), stop.get("clears", -1))
        return self.active

    def _latch(self, message: Message) -> None:
        told: Optional[int] = message.get("timestamp")
        stop = _stamped(message, self._micros()) if told is None else message
        identity = stop.get("stopId") or "|".join(
            [stop.get("systemId", ""), str(_micros(stop)), stop.get("operator", ""), stop.get("reason", "")])
        if self._repeats_lifted(identity, told):
            return
        before = self._standing.get(identity)
        if before is not None and (told is None or told == _micros(before)):
            return
        if before is not None or len(self._standing) < _TOLD_APART:
            if before is None or identity not in self._untimed:  # else repeated with the time of who received it
                self._arrived[identity] = time.monotonic(), before is not None
            if before is not None and _micros(stop) < _micros(before):
                return
            self._standing[identity] = stop
            (self._untimed.add if told is None else self._untimed.discard)(identity)
        elif self._beyond is None or _micros(stop) > _micros(self._beyond):
            self._beyond = stop

    def _repeats_lifted(self, identity: str, told: Optional[int]) -> bool:
        """Repetitions keep the timestamp, so another one is another stop, even if its sender uses one ID for all."""
        if identity not in self._lifted:
            return False
        before, lifted_s = self._lifted[identity]
        if told is None or before is None:
            return time.monotonic() - lifted_s <= _REPEATED_S
        return before == told

    def _lift(self, names: List[str], until: int) -> None:
        over = [each for each, stop in self._standing.items()
                if (each in names if names else _micros(stop) <= until) and not self._is_unknown(each, names, until)]
        for identity in over:
            at: Optional[int] = _micros(self._standing.pop(identity))
            self._arrived.pop(identity, None)
            if identity in self._untimed:
                self._untimed.discard(identity)
                at = None
            self._lifted.pop(identity, None)  # so that it comes last
            self._lifted[identity] = at, time.monotonic()
        while len(self._lifted) > 2 * _TOLD_APART:
            del self._lifted[next(iter(self._lifted))]
        if self._beyond is not None and _micros(self._beyond) <= until:
            self._beyond = None

    def _is_unknown(self, stop: str, names: List[str], until: int) -> bool:
        """Whether nobody who clears now can have known the stop."""
        arrived_s, is_again = self._arrived[stop]
        is_exact = not is_again if names else _micros(self._standing[stop]) == until
        return not is_exact and time.monotonic() - arrived_s < _UNKNOWN_S

    def _is_new(self, clear: Message) -> bool:
        """Whether a clear arrives for the first time; always for one without a timestamp."""
        known_by = identity(clear)
        if known_by is None:
            return True
        if known_by in self._clears:
            return False
        self._clears[known_by] = None
        while len(self._clears) > _TOLD_APART:
            del self._clears[next(iter(self._clears))]
        return True

    def _is_ours(self, clear: Message) -> bool:
        return self._system_id is None or clear.get("systemId", self._system_id) == self._system_id
