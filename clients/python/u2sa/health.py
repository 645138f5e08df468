"""What a service knows of its own condition (thesis 3.5.3)."""
from __future__ import annotations

import threading
import time
from typing import Any, Callable, Dict, List, Optional

from . import texts
from .message import Message

_REMEMBERED = 256
_MAX_COUNT = (1 << 63) - 1  # of the integers of a message
_ERROR_CHARACTERS = 1_000  # as HealthReport.lastError takes


class Health:
    """Counters of one service; written by its threads, read by any."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._took: List[float] = []
        self._running_since: Optional[float] = None
        self._counts: Dict[str, Any] = {"dropped": 0, "replaced": 0, "refused": 0, "overruns": 0, "exceptions": 0, "published": 0, "expired": 0, "missed": 0}
        self.last_error: Optional[str] = None
        self.in_a_row = 0

    def count(self, what: str, more: int = 1) -> None:
        """Adds to dropped, replaced, refused, overruns, exceptions, published, expired or missed, up to 64 bits: the numbers
        from which `missed` is counted are the sender's."""
        with self._lock:
            self._counts[what] = min(_MAX_COUNT, self._counts[what] + more)

    def run(self, code: Callable[[], None]) -> Optional[Exception]:
        """Runs an author's code, measures it, and returns the exception that it threw."""
        begun = time.monotonic()
        with self._lock:
            self._running_since = begun
        failure: Optional[Exception] = None
        try:
            code()
        except Exception as e:  # whatever an author's code throws is counted and survived
            failure = e
        with self._lock:
            self._running_since = None
            self._took = (self._took + [time.monotonic() - begun])[-_REMEMBERED:]
            self.in_a_row = self.in_a_row + 1 if failure else 0
        if failure:
            self.failed(failure)
        return failure

    def failed(self, failure: Exception) -> str:
        """Counts an exception and remembers its text, which is returned."""
        self.count("exceptions")
        self.last_error = texts.shortened(_ERROR_CHARACTERS, _text(failure))
        return self.last_error

    def report(self, service: str, status: str, inbox: int) -> Message:
        """A health report; the service adds instance and interval."""
        with self._lock:
            message = Message("HealthReport", serviceName=service, status=status, inboxDepth=inbox, **self._counts)
            message["callbackP50"] = self._percentile(0.50)
            message["callbackP99"] = self._percentile(0.99)
            if self.last_error is not None:
                message["lastError"] = self.last_error
            return message

    def running_s(self) -> float:
        """For how long the author's code has been running [s]; 0 if it is not."""
        with self._lock:
            return 0.0 if self._running_since is None else time.monotonic() - self._running_since

    def _percentile(self, share: float) -> float:
        ordered = sorted(self._took)
        return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0


def _text(failure: Exception) -> str:
    name = type(failure).__name__
    try:
        return f"{name}: {failure}"
    except Exception:  # of an author's own exception class
        return name
