"""What a connection does with what the broker refused or did not confirm."""
import threading
import types
import unittest

from u2sa.link import Broker, Link


def sent(topic, retain):
    return types.SimpleNamespace(topic=topic, retain=retain)


class FakeClient:
    """As much of paho's client as the connection touches, in 1.6 and 2.x alike."""

    def __init__(self):
        self._out_message_mutex = threading.Lock()
        self._out_messages = {1: sent("u2sa/cessna/stop/StopCommand", False), 2: sent("u2sa/cessna/goals/GoalList", True)}
        self._inflight_messages = 2

    def subscribe(self, topic_filter, _quality):
        return 0, 7


class LinkTest(unittest.TestCase):
    def setUp(self):
        self.troubles = []
        self.link = Link(Broker(), "cessna", "Motor", lambda *_: None, self.troubles.append)
        self.link._client = self.client = FakeClient()

    def test_a_lost_connection_drops_what_was_not_confirmed_but_for_retained_topics(self):
        self.link._retained.unconfirmed = lambda topics: self.troubles.append(tuple(topics))
        self.link._disconnected(self.client, None, 7)
        self.assertEqual(self.client._out_messages, {})
        self.assertEqual(self.client._inflight_messages, 0)
        self.assertEqual(self.troubles, [("u2sa/cessna/goals/GoalList",), "connection lost: 7"])

    def test_a_refused_subscription_is_told_once_and_known_by_its_channel(self):
        for _ in range(2):
            self.link.subscribe("u2sa/cessna/emergency-stop/#")
            self.link._subscribed(self.client, None, 7, [0x80])
        self.assertEqual(self.link.refused_channels(), ["emergency-stop"])
        self.assertEqual(len(self.troubles), 1)

    def test_a_subscription_granted_later_is_no_longer_refused(self):
        for code in (0x80, 1):
            self.link.subscribe("u2sa/cessna/emergency-stop/#")
            self.link._subscribed(self.client, None, 7, [code])
        self.assertEqual(self.link.refused_channels(), [])


if __name__ == "__main__":
    unittest.main()
