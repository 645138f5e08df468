"""The system's time: steady, and the same as that of the services that already run."""
from __future__ import annotations

import threading
import time
from typing import Callable, Optional

_TOLERATED_S = 0.1
_OTHERS_S = 0.2  # after the first answer
_REAL_SINCE_S = 1e9  # an earlier time is simulated time, which a real clock cannot follow
_REAL_UNTIL_S = 4_102_444_800.0  # 2100-01-01


class SystemTime:
    """This computer's time at the beginning, and steady from then on: setting the computer's clock does not change it. It follows the
    services that answer to discovery, as Java's launcher does: an answer was stamped between the question and its arrival (as in NTP,
    RFC 5905, section 8). Of answers that differ, the one nearest to this computer's time counts. Safe from any thread.
    """

    def __init__(self, wall: Callable[[], float] = time.time, steady: Callable[[], float] = time.monotonic) -> None:
        self._steady = steady
        self._offset = wall() - steady()  # from steady to the system's time
        self._lock = threading.Lock()
        self._asked: Optional[float] = None
        self._first: Optional[float] = None  # when the first answer came
        self._ahead = 0.0  # of this computer's time, by the answer that counts
        self._error = 0.0

    def seconds(self) -> float:
        """Time since 1970."""
        return self._steady() + self._offset

    def micros(self) -> int:
        """Time since 1970, as messages carry it."""
        return int(self.seconds() * 1e6)

    def asked(self) -> None:
        """A question is about to be sent."""
        with self._lock:
            self._asked = self._steady()
            self._first = None

    def hear(self, timestamp: Optional[int]) -> None:
        """An answer arrived that was stamped with this time; others than those to the question do not count."""
        with self._lock:
            if self._asked is None or timestamp is None or not _REAL_SINCE_S < timestamp / 1e6 < _REAL_UNTIL_S:
                return
            now = self._steady()
            error = (now - self._asked) / 2
            ahead = timestamp / 1e6 - (self._asked + error + self._offset)
            is_same = abs(ahead - self._ahead) <= _TOLERATED_S + error + self._error
            is_better = error < self._error if is_same else abs(ahead) < abs(self._ahead)
            if self._first is None or is_better:
                self._first = now if self._first is None else self._first
                self._ahead, self._error = ahead, error

    def is_settled(self) -> bool:
        """Whether waiting is over: an answer agrees with this computer, or the others have had twice as long as the first one took."""
        with self._lock:
            if self._asked is None or self._first is None:
                return False
            patience = max(_OTHERS_S, 2 * (self._first - self._asked))
            return self._agrees() or self._steady() - self._first > patience

    def _agrees(self) -> bool:
        return abs(self._ahead) <= _TOLERATED_S + self._error

    def follow(self) -> float:
        """Follows the answers from now on; returns by how much the system's time is ahead of this computer's, 0 if they agree."""
        with self._lock:
            followed = 0.0 if self._first is None or self._agrees() else self._ahead
            self._offset += followed
            self._asked = self._first = None
            return followed
