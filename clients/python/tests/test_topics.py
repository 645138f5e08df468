"""Topics, the level of the source, and retained messages after a broker came back."""
import unittest
from unittest import mock

from u2sa import Malformed, Message
from u2sa import retained as retained_module
from u2sa.retained import Retained
from u2sa.topics import Topic, delivery

STEM = "u2sa/boat/actuators/ActuatorAnnouncement"


class TopicTest(unittest.TestCase):
    def test_retained_messages_of_several_end_with_their_source(self):
        for name, level in (("RUDDER", "=RUDDER"), ("FLAP/1 %\n", "=FLAP%002F1%0020%0025%000A"), ("ü+", "=ü%002B"),
                            ("a.b*c>", "=a%002Eb%002Ac%003E")):
            topic = Topic.of("boat", "actuators", Message(
                "ActuatorAnnouncement", actuatorName=name, minimum=-100.0, maximum=100.0))
            self.assertEqual(str(topic), f"{STEM}/{level}")
            self.assertEqual(Topic.parse(str(topic)), topic)

    def test_other_messages_end_with_their_class(self):
        command = Message("PercentageCommand", actuatorName="RUDDER", percentage=0.0)
        self.assertEqual(str(Topic.of("boat", "actuation", command)), "u2sa/boat/actuation/ActuatorCommand/PercentageCommand")
        self.assertEqual(str(Topic.of("boat", "goals", Message("GoalList"))), "u2sa/boat/goals/GoalList")

    def test_sources_written_before_format_3_are_read(self):
        self.assertEqual(Topic.parse(f"{STEM}/=LEFT WHEEL 1.5").source, "LEFT WHEEL 1.5")

    def test_a_source_has_one_topic(self):
        for level in ("=", "=%2F", "=%0041", "=%002f", "=%", "=a#", "=a b%0020c"):
            with self.subTest(level), self.assertRaises(Malformed):
                Topic.parse(f"{STEM}/{level}")
        with self.assertRaises(Malformed):
            Topic.parse("u2sa/boat/actuators/=RUDDER")

    def test_delivery_is_that_of_the_table(self):
        self.assertEqual([delivery(name) for name in ("state", "actuators", "of-mine")], [(0, False), (1, True), (1, False)])


class RetainedTest(unittest.TestCase):
    def setUp(self):
        self.retained = Retained()
        self.client = mock.Mock()

    def restored(self, hold):
        with mock.patch.object(retained_module.threading, "Timer") as timer:
            self.retained.restore(self.client)
        for topic in hold:
            self.retained.arrived(topic)
        _wait, publish, arguments = timer.call_args.args
        publish(*arguments)
        return [call.args for call in self.client.publish.call_args_list]

    def test_what_the_broker_holds_is_left_alone(self):
        self.retained.publishing("a", b"1", True)
        self.retained.publishing("b", b"2", True)
        self.assertEqual(self.restored(hold=["a"]), [("b", b"2", 1, True)])
        self.assertEqual([call.args for call in self.client.subscribe.call_args_list], [("a", 0), ("b", 0)])
        self.assertEqual([call.args for call in self.client.unsubscribe.call_args_list], [("a",), ("b",)])

    def test_what_is_forgotten_is_not_said_again(self):
        self.retained.publishing("a", b"1", True)
        self.retained.publishing("b", b"2", True)
        self.retained.forget("b")
        self.assertEqual(self.restored(hold=[]), [("a", b"1", 1, True)])

    def test_what_was_said_while_the_connection_was_lost_is_said_then(self):
        self.retained.publishing("a", b"1", True)
        self.retained.publishing("a", b"2", False)
        self.assertEqual(self.restored(hold=["a"]), [("a", b"2", 1, True)])


if __name__ == "__main__":
    unittest.main()
