"""The system's time, from answers to discovery."""
import unittest

from u2sa.clock import SystemTime

HOUR = 3600.0
NOW = 1.8e9


class SystemTimeTest(unittest.TestCase):
    def setUp(self):
        self.wall, self.steady = NOW, 50.0
        self.time = SystemTime(lambda: self.wall, lambda: self.steady)

    def answer(self, ahead, after):
        """An answer that arrives so long after the question, stamped half way."""
        self.steady = 50.0 + after
        self.time.hear(int((NOW + ahead + after / 2) * 1e6))

    def test_setting_the_computers_clock_changes_nothing(self):
        self.wall, self.steady = NOW - HOUR, 60.0
        self.assertAlmostEqual(self.time.seconds(), NOW + 10.0, places=3)
        self.assertEqual(self.time.micros() // 1000, int((NOW + 10.0) * 1e3))

    def test_services_an_hour_ahead_are_followed(self):
        self.time.asked()
        self.answer(HOUR, 0.02)
        self.answer(HOUR + 0.3, 0.4)  # waited on its way
        self.assertAlmostEqual(self.time.follow(), HOUR, places=3)
        self.assertAlmostEqual(self.time.seconds(), NOW + HOUR + 0.4, places=3)

    def test_of_answers_that_differ_the_nearest_to_this_computer_counts(self):
        self.time.asked()
        self.answer(-HOUR, 0.01)
        self.assertFalse(self.time.is_settled())
        self.answer(0.05, 0.02)
        self.assertTrue(self.time.is_settled())
        self.answer(-HOUR, 0.03)
        self.assertEqual(self.time.follow(), 0.0)

    def test_others_have_twice_as_long_as_the_first_answer(self):
        self.time.asked()
        self.answer(HOUR, 0.4)
        self.steady = 50.0 + 1.1
        self.assertFalse(self.time.is_settled())
        self.steady = 50.0 + 1.3
        self.assertTrue(self.time.is_settled())

    def test_nobody_and_simulated_time_are_not_followed(self):
        self.time.hear(int((NOW + HOUR) * 1e6))  # nobody asked
        self.assertEqual(self.time.follow(), 0.0)
        self.time.asked()
        self.time.hear(12_000_000)
        self.time.hear(None)
        self.time.hear((1 << 63) - 1)
        self.assertFalse(self.time.is_settled())
        self.assertEqual(self.time.follow(), 0.0)
