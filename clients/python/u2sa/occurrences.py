"""Which of many like events are worth a line in the log."""
from __future__ import annotations

import threading
from typing import Dict, Optional


class Occurrences:
    """Counts events by kind; of each kind the 1st, 2nd, 4th, 8th… is logged, so that a flood does not fill the log.

    Safe from any thread.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._counts: Dict[str, int] = {}

    def to_log(self, kind: str) -> Optional[int]:
        """Counts an event.

        :param kind: one of a few constants of the program, never text from outside: each is kept
        :returns: how many there were, if this one is to be logged; else None
        """
        with self._lock:
            count = self._counts[kind] = self._counts.get(kind, 0) + 1
        return count if count & (count - 1) == 0 else None
