"""Numbers of messages: what was lost, and what came again."""
import unittest

from u2sa.gaps import Gaps

SENDER = "uuid of the Safety Manager"


class GapsTest(unittest.TestCase):
    def setUp(self):
        self.now = 0.0
        self.gaps = Gaps(lambda: self.now)

    def number(self, number, topic="arming-state", sender=SENDER):
        return self.gaps.missing_before(topic, (sender, number))

    def test_lost_and_repeated_messages_are_told_apart(self):
        self.assertEqual(self.number(3), 0)
        self.assertEqual(self.number(4), 0)
        self.assertEqual(self.number(7), 2)
        self.assertIsNone(self.number(7))
        self.assertIsNone(self.number(5))
        self.assertEqual(self.number(1, sender="another"), 0)
        self.assertEqual(self.number(1, topic="failsafe"), 0)
        self.assertEqual(self.gaps.missing_before("arming-state", None), 0)

    def test_a_number_that_somebody_else_chose_silences_a_sender_for_five_seconds(self):
        self.number(1)
        self.number(1 << 62)
        heard = []
        for number in range(2, 20):
            self.now += 1.0
            if self.number(number) is not None:
                heard.append(self.now)
        self.assertEqual(heard, [self.now - i for i in range(13, -1, -1)])
        self.assertEqual(heard[0], 5.0)

    def test_old_messages_that_come_again_for_long_stay_repeated(self):
        for number in range(10):
            self.number(number)
        for _ in range(20):
            self.now += 1.0
            self.assertIsNone(self.number(9))

    def test_senders_heard_longest_ago_are_forgotten(self):
        for sender in range(5000):
            self.number(5, sender=str(sender))
        self.assertEqual(self.number(5, sender="0"), 0)
        self.assertIsNone(self.number(5, sender="4999"))
