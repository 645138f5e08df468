"""Which of a sender's messages did not arrive, and which arrived again."""
from __future__ import annotations

import time
from typing import Callable, Dict, Optional, Tuple

_REMEMBERED = 4096  # senders and topics; a gap of a forgotten one is not detected
_REPETITIONS = 3
_REPEATED_FOR_S = 5.0


class _Heard:
    """The numbers of one sender on one topic."""

    def __init__(self) -> None:
        self._number: Optional[int] = None
        self._at = 0.0
        self._repeated = 0  # newest number that was not above the last one
        self._repetitions = 0  # of growing numbers

    def missing_before(self, number: int, now: float) -> Optional[int]:
        if self._number is not None and number <= self._number and not self._is_overtaken(number, now):
            return None
        missing = number - self._number - 1 if self._number is not None and number > self._number else 0
        self._number, self._at, self._repeated, self._repetitions = number, now, 0, 0
        return missing

    def _is_overtaken(self, number: int, now: float) -> bool:
        """Whether numbers below the last one have grown for long: somebody else used the sender's name with a higher one."""
        self._repetitions = self._repetitions + 1 if number > self._repeated else 1
        self._repeated = number
        return self._repetitions >= _REPETITIONS and now - self._at >= _REPEATED_FOR_S


class Gaps:
    """Reads the numbers of messages. For one thread."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._heard: Dict[Tuple[str, str], _Heard] = {}

    def missing_before(self, topic: str, origin: Optional[Tuple[str, int]]) -> Optional[int]:
        """How many messages were lost immediately before this one; None if its number is not above the last one's."""
        if origin is None:
            return 0
        sender, number = origin
        heard = self._heard.pop((sender, topic), None) or _Heard()
        self._heard[(sender, topic)] = heard  # so that the one heard last stands last
        while len(self._heard) > _REMEMBERED:
            del self._heard[next(iter(self._heard))]
        return heard.missing_before(number, self._clock())
