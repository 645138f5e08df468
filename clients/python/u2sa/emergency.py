"""The emergency stop as an actuator remembers it."""
from __future__ import annotations

import time
from typing import Optional

from .message import Message


class EmergencyLatch:
    """Latched by an EmergencyStop with active, lifted by one without that names it or a newer one in `clears`.

    On the safe side: a stop of unknown origin or time latches too, a clear of another system lifts nothing. Belongs to
    one thread.

    :param system_id: whose clears count; None: everybody's
    """

    def __init__(self, system_id: Optional[str] = None) -> None:
        self._system_id = system_id
        self._stopped_at: Optional[int] = None  # timestamp of the newest stop that holds [µs]
        self._lifted: Optional[int] = None  # timestamp of the stop that was lifted last [µs]

    @property
    def active(self) -> bool:
        """Whether a stop holds."""
        return self._stopped_at is not None

    def take(self, stop: Message) -> bool:
        """Takes note of a message of the channel emergency-stop; returns whether everything must be neutral now.

        A repetition of the stop that was lifted last, of one who has not heard of the clear, changes nothing.
        """
        if stop.get("active"):
            at = stop.get("timestamp", time.time_ns() // 1000)
            if self.active or at != self._lifted:
                self._stopped_at = max(at, self._stopped_at or at)
        elif self._stopped_at is not None and self._is_ours(stop) and stop.get("clears", -1) >= self._stopped_at:
            self._lifted, self._stopped_at = self._stopped_at, None
        return self.active

    def _is_ours(self, clear: Message) -> bool:
        return self._system_id is None or clear.get("systemId", self._system_id) == self._system_id
