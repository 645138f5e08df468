"""What a connection published to be retained: a broker that came back without its memory gets it again."""
from __future__ import annotations

import threading
from typing import Any, Dict, List, Set

_ANSWER_WITHIN_S = 1.0


class Retained:
    """The last retained message of each topic. Safe from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._last: Dict[str, bytes] = {}
        self._unsent: Set[str] = set()  # topics whose last message came while there was no connection
        self._lacking: Set[str] = set()  # topics of which the broker has not shown that it holds a message

    def publishing(self, topic: str, payload: bytes, connected: bool) -> None:
        """Takes note of a message, whether it can be sent or not."""
        with self._lock:
            self._last[topic] = payload
            self._lacking.discard(topic)
            self._unsent.discard(topic)
            if not connected:
                self._unsent.add(topic)

    def forget(self, topic: str) -> None:
        """Leaves a topic to others."""
        with self._lock:
            self._last.pop(topic, None)
            self._lacking.discard(topic)
            self._unsent.discard(topic)

    def unconfirmed(self, topics: List[str]) -> None:
        """Takes note that the broker may not have got the last message of these topics."""
        with self._lock:
            self._unsent.update(topic for topic in topics if topic in self._last)

    def arrived(self, topic: str) -> None:
        """Takes note that the broker holds a message; what somebody else published meanwhile is left alone."""
        with self._lock:
            self._lacking.discard(topic)

    def restore(self, client: Any) -> None:
        """Asks the broker of a new session what it holds, and publishes what it lacks a second later."""
        with self._lock:
            self._lacking = set(self._last)
            topics = sorted(self._lacking)
        for topic in topics:
            client.subscribe(topic, 0)
        if topics:
            timer = threading.Timer(_ANSWER_WITHIN_S, self._publish, (client, topics))
            timer.daemon = True
            timer.start()

    def _publish(self, client: Any, topics: List[str]) -> None:
        for topic in topics:
            client.unsubscribe(topic)
        with self._lock:  # what is published meanwhile comes behind
            for topic in sorted(self._lacking | self._unsent):
                client.publish(topic, self._last[topic], 1, True)
            self._lacking, self._unsent = set(), set()
