"""A service's answers, without a broker: what it sends is looked at."""
import time
import unittest
import unittest.mock

from u2sa import EmergencyLatch, Message, Service, Variable, encode
from u2sa.contract import Contract


class Probe(Service):
    _newest = _inbox = _thread = _contract = None  # an author's names do not get in the way
    role = "PROPRIOCEPTIVE_SENSOR"

    def __init__(self):
        super().__init__("Probe", variables=(Variable("GAIN", 0.5, "", 0.0, 1.0),))
        self.register_publisher("sensed-state", "StateInformation")
        self.register_subscriber("goals", "GoalList")
        self.sent = []
        self.changed = []
        self.link.publish = lambda channel, message: self.sent.append((channel, message)) or bool(encode(message))

    def configuration_changed(self, names):
        self.changed += names

    def hear(self, channel, message):
        """As if it had come over the line."""
        self._arrived("/".join(("u2sa", "cessna", channel, *message.chain)), encode(message))
        while self._Service__inbox.depth():
            self._take(0.0)


class ContractTest(unittest.TestCase):
    def setUp(self):
        self.probe = Probe()

    def answer(self, channel, message):
        self.probe.sent.clear()
        self.probe.hear(channel, message)
        return self.probe.sent[0][1] if self.probe.sent else None

    def test_discovery_tells_who_it_is(self):
        answer = self.answer("discovery", Message("DiscoveryRequest"))
        self.assertEqual((answer["serviceName"], answer["serviceType"]), ("Probe", "PROPRIOCEPTIVE_SENSOR"))
        self.assertEqual(answer["instance"], self.probe.link.instance)

    def test_functionality_tells_channels_with_chains(self):
        answer = self.answer("functionality", Message("FunctionalityRequest", serviceName=""))
        self.assertEqual(answer["publishes"], ("sensed-state/StateInformation",))
        self.assertEqual(answer["subscribes"], ("goals/GoalList",))
        self.assertIsNone(self.answer("functionality", Message("FunctionalityRequest", serviceName="Other")))

    def test_configuration_is_told_with_limits_and_revision(self):
        answer = self.answer("configuration", Message("ConfigurationRequest", serviceName="Probe"))
        gain = answer["variables"][0]
        self.assertEqual((gain["name"], gain["value"], gain["min"], gain["max"]), ("GAIN", "0.5", 0.0, 1.0))
        self.assertEqual(answer["revision"], 0)

    def test_gaps_in_a_senders_numbers_are_counted(self):
        topic = "u2sa/cessna/goals/GoalList"
        for sender, number in (("a", 1), ("a", 2), ("b", 7), ("a", 5), ("a", 5), ("a", 4), ("b", 8)):
            self.probe._arrived(topic, encode(Message("GoalList"), (sender, number)))
        self.assertEqual(self.probe.health.report("Probe", "RUNNING", 0)["missed"], 2)

    def test_health_tells_how_old_the_data_are_and_counts_no_answers(self):
        report = self.probe._described(self.probe.health.report("Probe", "RUNNING", 0))
        self.assertNotIn("dataAge", report)
        self.answer("discovery", Message("DiscoveryRequest"))
        self.probe.publish("sensed-state", Message("StateInformation"))
        report = self.probe._described(self.probe.health.report("Probe", "RUNNING", 0))
        self.assertEqual(report["published"], 1)
        self.assertTrue(0.0 <= report["dataAge"] < 60.0)

    def test_health_tells_which_emergency_stops_hold_if_the_service_heeds_them(self):
        report = self.probe._described(self.probe.health.report("Probe", "RUNNING", 0))
        self.assertNotIn("emergencyStops", report)
        self.probe.register_subscriber("emergency-stop", "EmergencyStop")
        self.probe._report()
        self.assertEqual(self.probe.sent[-1][1]["emergencyStops"], ())
        self.probe.hear("emergency-stop", Message("EmergencyStop", active=True, operator="me", reason="r", stopId="me 1"))
        self.assertTrue(self.probe.emergency.active)
        self.probe._report()
        self.assertEqual(self.probe.sent[-1][1]["emergencyStops"], ("me 1",))
        self.probe.hear("emergency-stop", Message(
            "EmergencyStop", systemId="cessna", active=False, operator="me", reason="", lifts=("me 1",)))
        self.assertFalse(self.probe.emergency.active)

    def test_an_actuator_repeats_the_stop_that_a_clear_leaves(self):
        self.probe.role = "ACTUATOR"
        self.probe.log.disabled = True
        self.probe.register_subscriber("emergency-stop", "EmergencyStop")
        for name, timestamp in (("old", 10), ("new", 20)):
            self.probe.hear("emergency-stop", Message(
                "EmergencyStop", active=True, operator="me", reason="r", stopId=name, timestamp=timestamp))
        clear = Message("EmergencyStop", systemId="cessna", active=False, operator="you", reason="", lifts=("new",))
        self.assertEqual(
            [("emergency-stop", "old", 10, True)],
            [(channel, each["stopId"], each["timestamp"], each["active"]) for channel, each in self._said(clear)])
        self.assertEqual({}, self.probe.link._retained._last)  # a restarted broker gets it from the Safety Manager
        clear["lifts"] = ("old",)
        self.assertEqual([], self._said(clear))
        self.assertFalse(self.probe.emergency.active)

    def _said(self, message):
        """What the message makes the probe say on the emergency stop's channel."""
        self.probe.sent.clear()
        self.probe.hear("emergency-stop", message)
        return [each for each in self.probe.sent if each[0] == "emergency-stop"]

    def test_who_moves_nothing_repeats_no_stop(self):
        self.probe.register_subscriber("emergency-stop", "EmergencyStop")
        self.probe.hear("emergency-stop", Message("EmergencyStop", active=True, stopId="a", operator="me", reason="r"))
        clear = Message("EmergencyStop", systemId="cessna", active=False, operator="you", reason="", lifts=("b",))
        self.assertEqual([], self._said(clear))
        self.assertTrue(self.probe.emergency.active)

    def test_a_change_is_made_or_refused_with_the_reason(self):
        answer = self.answer("configuration", Message(
            "ConfigurationChange", serviceName="Probe", variableName="GAIN", value="0.75"))
        self.assertTrue(answer["accepted"])
        self.assertEqual(self.probe.changed, ["GAIN"])
        answer = self.answer("configuration", Message(
            "ConfigurationChange", serviceName="Probe", variableName="GAIN", value="7"))
        self.assertFalse(answer["accepted"])
        self.assertIn("7 is outside 0.0…1.0", answer["reason"])

    def test_a_transaction_that_comes_twice_is_obeyed_once(self):
        wanted = Message("ConfigurationAssignment", variableName="GAIN", value="0.75")
        order = Message("ConfigurationTransaction", requestId="r", serviceName="Probe", assignments=[wanted], revision=0)
        first = self.answer("configuration", order)
        second = self.answer("configuration", order)
        self.assertTrue(first["accepted"])
        self.assertEqual((first, first["revision"]), (second, 1))
        undone = self.answer("configuration", Message("ConfigurationUndo", requestId="u", serviceName="Probe"))
        self.assertEqual(undone["assignments"][0]["value"], "0.5")
        self.assertEqual(self.probe.configuration["GAIN"], 0.5)

    def test_a_change_that_comes_twice_is_made_once(self):
        order = Message("ConfigurationChange", serviceName="Probe", variableName="GAIN", value="0.75", timestamp=int(time.time() * 1e6))
        first = self.answer("configuration", order)
        self.answer("configuration", Message("ConfigurationUndo", requestId="u", serviceName="Probe"))
        self.assertEqual(self.answer("configuration", order), first)
        self.assertEqual(self.probe.configuration["GAIN"], 0.5)

    def test_orders_under_one_id_are_each_obeyed(self):
        def order(gain, **more):
            wanted = Message("ConfigurationAssignment", variableName="GAIN", value=gain)
            return Message("ConfigurationTransaction", requestId="1", serviceName="Probe", assignments=[wanted], **more)

        for gain in ("0.75", "0.25"):
            self.assertEqual(self.answer("configuration", order(gain))["assignments"][0]["value"], gain)
        now = time.time()
        self.assertFalse(self.answer("configuration", order("0.1", timestamp=int((now - 60) * 1e6)))["accepted"])
        self.assertTrue(self.answer("configuration", order("0.1", timestamp=int(now * 1e6)))["accepted"])
        self.assertEqual(self.probe.configuration["GAIN"], 0.1)
        self.assertTrue(self.answer("configuration", order("0.3", timestamp=int(now * 1e6)))["accepted"])
        self.assertTrue(self.answer("configuration", order("0.1", timestamp=int((now + 1) * 1e6)))["accepted"])
        self.assertEqual(self.probe.configuration["GAIN"], 0.1, "given again")

    def test_orders_older_than_their_expiry_are_refused(self):
        def ago(seconds):
            return int((time.time() - seconds) * 1e6)

        self.probe.hear("stop", Message("StopCommand", serviceName="Probe", timestamp=ago(20)))
        self.assertFalse(self.probe._Service__stopping.is_set())
        gain = [Message("ConfigurationAssignment", variableName="GAIN", value="0.9")]
        for seconds, expected in ((20, False), (4, True)):
            answer = self.answer("configuration", Message(
                "ConfigurationTransaction", requestId=str(seconds), serviceName="Probe", author="me", assignments=gain,
                timestamp=ago(seconds)))
            self.assertEqual(answer["accepted"], expected)
            self.assertEqual("after it was given" in answer.get("reason", ""), not expected)
        undo = self.answer("configuration", Message(
            "ConfigurationUndo", requestId="u", serviceName="Probe", author="me", timestamp=ago(20)))
        self.assertFalse(undo["accepted"])
        self.assertEqual(self.probe.configuration.number("GAIN"), 0.9)
        self.probe.hear("stop", Message("StopCommand", serviceName="Probe", timestamp=ago(4)))
        self.assertTrue(self.probe._Service__stopping.is_set())

    def test_an_old_state_does_not_follow_a_new_one_and_a_stop_always_counts(self):
        def arrives(channel, message, number):
            self.probe._arrived("/".join(("u2sa", "cessna", channel, *message.chain)), encode(message, ("a", number)))
            return self.probe._Service__inbox.depth()

        self.probe.register_subscriber("failsafe", "FailsafeState")
        self.probe.register_subscriber("emergency-stop", "EmergencyStop")
        self.assertEqual(arrives("failsafe", Message("FailsafeState", action="HOLD"), 7), 1)
        self.assertEqual(arrives("failsafe", Message("FailsafeState", action="CONTINUE"), 6), 1)
        stop = Message("EmergencyStop", active=True, operator="me", reason="r", stopId="s")
        self.assertEqual(arrives("emergency-stop", stop, 9), 2)
        self.assertEqual(arrives("emergency-stop", stop, 3), 3)

    def test_a_stop_is_obeyed_where_it_arrives(self):
        self.probe.hear("stop", Message("StopCommand", serviceName="Other"))
        self.assertFalse(self.probe._Service__stopping.is_set())
        self.probe.hear("stop", Message("StopCommand", serviceName="Probe"))
        self.assertTrue(self.probe._Service__stopping.is_set())

    def test_a_stop_that_was_retained_or_is_disguised_is_none(self):
        stop = encode(Message("StopCommand", stopAll=True))
        self.probe._arrived("u2sa/cessna/stop/StopCommand", stop, True)
        self.probe._arrived("u2sa/cessna/discovery/DiscoveryRequest/StopCommand", stop)
        self.probe._arrived("u2sa/cessna/discovery/StopCommand", stop)
        self.assertEqual([], self.probe.sent)
        self.assertFalse(self.probe._Service__stopping.is_set())

    def test_a_change_on_another_channel_is_none(self):
        change = Message("ConfigurationChange", serviceName="Probe", variableName="GAIN", value="7")
        self.assertFalse(self.probe._Service__contract.concerns("goals", change))

    def test_requests_come_in_on_channels_that_are_subscribed_to(self):
        channels = [channel for channel, _chain in self.probe._filters()]
        self.assertEqual(channels, ["goals", *Contract.CHANNELS])

    def test_what_cannot_be_read_is_counted(self):
        self.probe._arrived("u2sa/cessna/goals/GoalList", b"\xff")
        self.probe._arrived("elsewhere", b"")
        report = self.probe.health.report("Probe", "RUNNING", 0)
        self.assertEqual(report["refused"], 2)

    def test_publishing_what_was_not_registered_is_refused(self):
        self.assertFalse(self.probe.publish("state", Message("StateInformation")))

    def test_errors_in_a_row_end_it_as_failed(self):
        def wrong():
            raise ValueError("no device")
        self.probe.log.disabled = True
        self.addCleanup(setattr, self.probe.log, "disabled", False)
        for _ in range(10):
            self.probe._guarded(wrong)
        self.assertEqual(self.probe.status, "FAILED")
        self.assertEqual(self.probe.health.report("Probe", "FAILED", 0)["lastError"], "ValueError: no device")


class HostileOriginTest(unittest.TestCase):
    def test_numbers_whose_gaps_add_up_beyond_64_bits_can_be_reported(self):
        probe = Probe()
        for sender in ("a", "b"):
            for number in (1, (1 << 63) - 1):
                probe._arrived("u2sa/cessna/discovery/DiscoveryRequest", encode(Message("DiscoveryRequest"), (sender, number)))
        probe._report()
        self.assertEqual(probe.sent[-1][1]["missed"], (1 << 63) - 1)

    def test_unreadable_messages_are_logged_at_powers_of_two(self):
        probe = Probe()
        with self.assertLogs(probe.log, "WARNING") as logged:
            for _ in range(100):
                probe._arrived("u2sa/cessna/goals/GoalList", b"no CBOR")
        self.assertEqual(len(logged.output), 7)
        self.assertEqual(probe.health.report("Probe", "RUNNING", 0)["refused"], 100)


def later(seconds):
    """Time that has passed for the latch."""
    now = time.monotonic()
    return unittest.mock.patch("u2sa.emergency.time.monotonic", lambda: now + seconds)


class EmergencyLatchTest(unittest.TestCase):
    def stopped(self, latch, **fields):
        return latch.take(Message("EmergencyStop", active=True, operator="button", reason="pressed", **fields))

    def test_a_later_stop_under_the_lifted_ones_id_latches_again_and_its_repetition_does_not(self):
        latch = EmergencyLatch()
        self.stopped(latch, stopId="button", timestamp=100)
        latch.take(Message("EmergencyStop", active=False, lifts=["button"]))
        self.assertFalse(self.stopped(latch, stopId="button", timestamp=100))
        self.assertFalse(self.stopped(latch, stopId="button"))
        self.assertTrue(self.stopped(latch, stopId="button", timestamp=101))
        self.assertEqual(latch.stops, ["button"])

    def test_named_stops_are_told_apart_whatever_their_time(self):
        latch = EmergencyLatch("boat")
        latch.take(Message("EmergencyStop", active=True, timestamp=100, stopId="a"))
        latch.take(Message("EmergencyStop", active=True, timestamp=100, stopId="b"))
        self.assertTrue(latch.take(Message("EmergencyStop", active=False, lifts=["a"], clears=500)))
        self.assertEqual(["b"], latch.stops)
        self.assertFalse(latch.take(Message("EmergencyStop", active=False, clears=100)))
        self.assertFalse(latch.take(Message("EmergencyStop", active=True, timestamp=100, stopId="a")))
        self.assertTrue(latch.take(Message("EmergencyStop", active=True, timestamp=100)))

    def test_only_a_clear_of_the_newest_stop_lifts_it(self):
        latch = EmergencyLatch()
        latch.take(Message("EmergencyStop", active=True, timestamp=10))
        latch.take(Message("EmergencyStop", active=True, timestamp=20))
        self.assertTrue(latch.take(Message("EmergencyStop", active=False, clears=10, timestamp=30)))
        self.assertTrue(latch.take(Message("EmergencyStop", active=False, timestamp=30)))
        self.assertFalse(latch.take(Message("EmergencyStop", active=False, clears=20, timestamp=30)))

    def test_a_clear_that_arrives_again_leaves_the_stop_of_a_clock_that_is_behind(self):
        latch = EmergencyLatch()
        self.stopped(latch, timestamp=100)
        clear = Message("EmergencyStop", active=False, operator="me", reason="", clears=200, timestamp=200)
        with later(0.5):
            self.assertFalse(latch.take(clear))
            self.assertTrue(self.stopped(latch, timestamp=50))
        with later(1.5):
            self.assertTrue(latch.take(clear))
            clear["timestamp"] = 201  # given again
            self.assertFalse(latch.take(clear))

    def test_who_clears_cannot_have_known_a_stop_that_has_just_arrived(self):
        latch = EmergencyLatch()
        self.stopped(latch, stopId="button", timestamp=100)
        with later(1):
            self.assertTrue(self.stopped(latch, stopId="button", timestamp=50))
            self.assertTrue(latch.take(Message("EmergencyStop", active=False, clears=200)))
            self.assertTrue(latch.take(Message("EmergencyStop", active=False, lifts=["button"])))
        with later(1.5):
            self.assertFalse(latch.take(Message("EmergencyStop", active=False, lifts=["button"])))

    def test_a_repetition_of_the_lifted_stop_does_not_latch_again_and_a_new_one_does(self):
        latch = EmergencyLatch()
        stop = Message("EmergencyStop", active=True, timestamp=10)
        latch.take(stop)
        latch.take(Message("EmergencyStop", active=False, clears=10, timestamp=30))
        self.assertFalse(latch.take(stop))
        self.assertTrue(latch.take(Message("EmergencyStop", active=True, timestamp=40)))

    def test_the_newest_stop_is_the_one_that_came_last_of_equal_ones(self):
        latch = EmergencyLatch()
        self.assertIsNone(latch.newest)
        for name, timestamp in (("a", 20), ("b", 20), ("c", 10)):
            latch.take(Message("EmergencyStop", active=True, stopId=name, timestamp=timestamp))
        self.assertEqual("b", latch.newest["stopId"])

    def test_a_stop_without_a_time_is_known_by_when_it_came(self):
        latch = EmergencyLatch()
        latch.take(Message("EmergencyStop", active=True, operator="me", reason="r"))
        self.assertEqual([f"|{latch.newest['timestamp']}|me|r"], latch.stops)

    def test_who_could_be_wrong_is_wrong_on_the_safe_side(self):
        latch = EmergencyLatch("boat")
        self.assertTrue(latch.take(Message("EmergencyStop", active=True)))  # when is not said
        foreign = Message("EmergencyStop", systemId="other", active=False, clears=1 << 60)
        self.assertTrue(latch.take(foreign))
        foreign["systemId"] = "boat"
        with later(0.5):
            self.assertFalse(latch.take(foreign))


if __name__ == "__main__":
    unittest.main()
