"""What others send must not end a service, nor fill its log."""
import types
import unittest

from u2sa import Message, Service, encode
from u2sa.codec import decode
from u2sa.health import Health
from u2sa.link import Broker, Link
from u2sa.occurrences import Occurrences
from u2sa.schema import Malformed

LARGEST = (1 << 63) - 1


class Survivor(Service):
    """A service whose link is a test's: what it sends is kept, or fails."""

    rate_hz = 1000.0

    def __init__(self):
        super().__init__("Survivor")
        self.register_subscriber("goals", "GoalList")
        self.sent = []
        self.steps = 0
        self.link.publish = lambda channel, message: bool(encode(message)) and not self.sent.append((channel, message))

    def step(self, now_s):
        self.steps += 1
        if self.steps == 20:
            self.stop()

    def hear(self, message, channel, origin=None):
        self._arrived("/".join(("u2sa", "cessna", channel, *message.chain)), encode(message, origin))
        while self._Service__inbox.depth():
            self._take(0.0)


class SurvivalTest(unittest.TestCase):
    def setUp(self):
        self.service = Survivor()

    def test_senders_numbers_near_the_end_of_64_bits_leave_the_health_report_whole(self):
        for sender in ("a", "b", "c"):
            for number in (1, LARGEST):
                self.service.hear(Message("DiscoveryRequest"), "discovery", (sender, number))
        self.service._report()
        channel, report = self.service.sent[-1]
        self.assertEqual((channel, report["missed"]), ("health", LARGEST))

    def test_a_number_beyond_64_bits_is_refused(self):
        payload = encode(Message("DiscoveryRequest"), ("a", LARGEST + 1))
        with self.assertRaisesRegex(Malformed, "origin: expected the sender and a number from 1 of 64 bits"):
            decode(("DiscoveryRequest",), payload)

    def test_a_health_report_that_fails_is_logged_and_the_service_goes_on(self):
        def failing(channel, message):
            if channel == "health":
                raise ValueError("too large")
            return True
        self.service.link = types.SimpleNamespace(
            open=lambda **_: None, close=lambda: None, subscribe=lambda _filter: None, publish=failing, instance="i",
            refused_channels=lambda: [])
        self.service.configuration._values["HEALTH INTERVAL"] = 0.01
        with self.assertLogs("u2sa.Survivor", "ERROR") as logged:
            self.assertEqual(self.service.run(signals=False), 0)
        self.assertEqual(self.service.steps, 20)
        self.assertIn("the health report failed (1 times so far): ValueError: too large", logged.output[0])
        self.assertEqual(self.service.health.last_error, "ValueError: too large")

    def test_answers_that_fail_do_not_count_as_the_authors_exceptions_in_a_row(self):
        self.service.status = "RUNNING"
        self.service.link.publish = lambda channel, message: 1 // 0
        with self.assertLogs("u2sa.Survivor", "ERROR") as logged:
            for _ in range(100):
                self.service.hear(Message("DiscoveryRequest"), "discovery")
        self.assertEqual((self.service.status, self.service.health.in_a_row), ("RUNNING", 0))
        self.assertEqual(len(logged.output), 7)  # 1, 2, 4, 8, 16, 32 and 64
        self.assertEqual(self.service.health.report("Survivor", "RUNNING", 0)["exceptions"], 100)

    def test_a_refused_transaction_as_large_as_a_message_may_be_is_answered(self):
        wanted = [Message("ConfigurationAssignment", variableName=f"X{i}", value=" " * 65_430) for i in range(16)]
        order = Message("ConfigurationTransaction", requestId="r", serviceName="Survivor", assignments=wanted)
        order["requestId"] = "r" * ((1 << 20) - len(encode(order)) - 2)
        self.assertGreater(len(encode(order)), (1 << 20) - 10)
        self.service.hear(order, "configuration")
        channel, result = self.service.sent[-1]
        self.assertEqual((channel, result["accepted"]), ("configuration", False))
        self.assertIn('variable "X0"', result["reason"])

    def test_a_flood_of_unreadable_messages_does_not_fill_the_log(self):
        topic = "u2sa/cessna/goals/GoalList\n" + "x" * 10_000
        with self.assertLogs("u2sa.Survivor", "WARNING") as logged:
            for _ in range(1_000):
                self.service._arrived(topic, b"\xff" * 100)
        self.assertEqual(len(logged.output), 10)  # 1, 2, 4 … 512
        self.assertIn("(512 so far)", logged.output[-1])
        self.assertTrue(all(len(line) < 2_000 and "\n" not in line for line in logged.output), logged.output[-1])
        self.assertEqual(self.service.health.report("Survivor", "RUNNING", 0)["refused"], 1_000)

    def test_an_exception_without_a_text_is_counted(self):
        class Silent(Exception):
            def __str__(self):
                raise RuntimeError("no text")

        def raising():
            raise Silent()
        self.assertIsInstance(self.service.health.run(raising), Silent)
        self.assertEqual(self.service.health.last_error, "Silent")

    def test_counts_end_at_64_bits(self):
        health = Health()
        for _ in range(2):
            health.count("missed", LARGEST)
        self.assertEqual(health.report("x", "RUNNING", 0)["missed"], LARGEST)


class LinkSurvivalTest(unittest.TestCase):
    def test_an_exception_in_a_callback_leaves_pahos_thread_running(self):
        troubles = []
        link = Link(Broker(), "cessna", "Motor", lambda *_: 1 // 0, troubles.append)
        for _ in range(100):
            link._client.on_message(None, None, types.SimpleNamespace(topic="t", payload=b"", retain=False))
        self.assertEqual(len(troubles), 7)
        self.assertIn("receiving a message failed (1 times so far): ZeroDivisionError", troubles[0])


class OccurrencesTest(unittest.TestCase):
    def test_the_1st_2nd_4th_and_so_on_of_each_kind_are_logged(self):
        occurrences = Occurrences()
        self.assertEqual([occurrences.to_log("a") for _ in range(5)], [1, 2, None, 4, None])
        self.assertEqual(occurrences.to_log("b"), 1)


if __name__ == "__main__":
    unittest.main()
