"""The emergency stop as an actuator remembers it."""
from __future__ import annotations

from .message import Message


class EmergencyLatch:
    """Latched by an EmergencyStop with active, lifted by one without that names it or a newer one in `clears`."""

    def __init__(self) -> None:
        self._stopped_at = -1  # timestamp of the newest stop [µs]
        self.active = False

    def take(self, stop: Message) -> bool:
        """Takes note of a message of the channel emergency-stop; returns whether everything must be neutral now."""
        if stop.get("active"):
            self.active = True
            self._stopped_at = max(self._stopped_at, stop.get("timestamp", 0))
        elif self.active and stop.get("clears", -1) >= self._stopped_at:
            self.active = False
        return self.active
