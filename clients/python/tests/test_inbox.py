"""Which message waits, which is replaced, and which comes first."""
import threading
import unittest

from u2sa import Message
from u2sa.inbox import LATEST, Inbox
from u2sa.tables import CHANNELS


def state(sensor, x=1.0):
    return Message("StateInformation", sensorName=sensor, x=x)


STOP = Message("EmergencyStop", active=True, operator="me", reason="r", stopId="me 1")


class InboxTest(unittest.TestCase):
    def setUp(self):
        self.inbox = Inbox(3)

    def contents(self):
        found = []
        while self.inbox.depth():
            found.append(self.inbox.take(0.0))
        return found

    def fill(self):
        for number in range(3):
            self.assertEqual(self.inbox.put("goal-commands", Message("GoalCommand", uid=str(number))), "")
        self.assertEqual(self.inbox.put("goal-commands", Message("GoalCommand", uid="one too many")), "dropped")

    def test_an_emergency_stop_overtakes_a_full_inbox(self):
        self.fill()
        self.assertEqual(self.inbox.put("emergency-stop", STOP), "")
        self.assertEqual(self.inbox.depth(), 4)
        self.assertEqual(self.inbox.take(0.0), ("emergency-stop", STOP))

    def test_arming_and_failsafes_have_room_of_their_own_and_keep_their_place(self):
        self.fill()
        self.assertEqual(self.inbox.put("arming", Message("ArmCommand", arm=True, operator="me")), "")
        self.assertEqual(self.inbox.put("goal-commands", Message("GoalCommand", uid="x")), "dropped")
        self.assertEqual([channel for channel, _ in self.contents()], ["goal-commands"] * 3 + ["arming"])
        self.assertEqual(self.inbox.put("goal-commands", Message("GoalCommand", uid="y")), "")

    def test_long_messages_have_a_bound_of_their_own_which_stops_do_not_have(self):
        inbox = Inbox(100, max_bytes=250)

        def received(sensor, size):
            message = state(sensor)
            message.received_bytes = size
            return message

        outcomes = [inbox.put("sensed-state", received(str(number), 100)) for number in range(3)]
        self.assertEqual(outcomes, ["", "", "dropped"])
        self.assertEqual(inbox.put("sensed-state", received("0", 200)), "dropped")
        self.assertEqual(inbox.put("sensed-state", received("0", 50)), "replaced")
        self.assertEqual(inbox.put("emergency-stop", STOP), "")
        inbox.take(0.0), inbox.take(0.0)
        self.assertEqual(inbox.put("sensed-state", received("3", 150)), "")

    def test_reserved_room_ends_too(self):
        outcomes = [self.inbox.put("arming", Message("ArmCommand", arm=True, operator=str(i))) for i in range(4)]
        self.assertEqual(outcomes, ["", "", "", "dropped"])

    def test_a_newer_message_of_a_source_takes_the_place_of_the_waiting_one(self):
        self.inbox.put("sensed-state", state("GPS"))
        self.inbox.put("sensed-state", state("Compass"))
        self.assertEqual(self.inbox.put("sensed-state", state("GPS", 2.0)), "replaced")
        self.assertEqual([(m["sensorName"], m["x"]) for _, m in self.contents()], [("GPS", 2.0), ("Compass", 1.0)])
        self.assertEqual(self.inbox.put("sensed-state", state("GPS", 3.0)), "")

    def test_the_same_source_on_another_channel_is_another(self):
        self.inbox.put("sensed-state", state("GPS"))
        self.assertEqual(self.inbox.put("state", state("GPS")), "")

    def test_what_is_said_about_a_lost_service_does_not_replace_its_own_report(self):
        self.inbox.put("health", Message("HealthReport", serviceName="Motor", status="RUNNING"))
        self.assertEqual(self.inbox.put("health", Message("ConnectionLost", serviceName="Motor", status="FAILED", lastError="x")), "")

    def test_waking_ends_the_wait_without_a_message(self):
        threading.Timer(0.01, self.inbox.wake).start()
        self.assertIsNone(self.inbox.take(60.0))
        self.assertIsNone(self.inbox.take(0.0))

    def test_the_latest_channels_are_standard_ones(self):
        self.assertLessEqual(set(LATEST), set(CHANNELS))


if __name__ == "__main__":
    unittest.main()
