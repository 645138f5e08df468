"""Names and identifiers beyond their bound are refused, notes are shortened: docs/wire-protocol.md, Names and notes."""
import unittest

from u2sa import Malformed, Message, decode


def note(reason):
    return Message("Waypoint", uid="1", reason=reason)["reason"]


def units(text):
    return len(text.encode("utf-16-le")) // 2


class TextsTest(unittest.TestCase):
    def test_name_of_255_characters_is_taken_and_of_256_refused(self):
        self.assertEqual(len(Message("StateInformation", sensorName="n" * 255)["sensorName"]), 255)
        with self.assertRaisesRegex(Malformed, "StateInformation.sensorName: expected at most 255 characters, not 256"):
            Message("StateInformation", sensorName="n" * 256)

    def test_name_counts_utf16_units(self):
        self.assertEqual(Message("StateInformation", sensorName="😀" * 127)["sensorName"], "😀" * 127)
        with self.assertRaises(Malformed):
            Message("StateInformation", sensorName="😀" * 128)

    def test_identifiers_in_a_list_are_refused_beyond_1000(self):
        self.assertEqual(Message("Waypoint", uid="1", next=["n" * 1000])["next"], ("n" * 1000,))
        with self.assertRaises(Malformed):
            Message("Waypoint", uid="1", next=["n" * 1001])

    def test_long_name_on_the_wire_is_refused(self):
        key = b"\x6asensorName"
        for length, is_taken in ((255, True), (256, False)):
            payload = b"\xa1" + key + b"\x79" + length.to_bytes(2, "big") + b"n" * length
            with self.subTest(length):
                if is_taken:
                    self.assertEqual(decode(["StateInformation"], payload)["sensorName"], "n" * length)
                else:
                    with self.assertRaises(Malformed):
                        decode(["StateInformation"], payload)

    def test_note_up_to_1000_stays(self):
        for reason in ("", "wind", "é" * 1000, "😀" * 500):
            with self.subTest(reason[:3]):
                self.assertEqual(note(reason), reason)

    def test_longer_note_is_cut_and_says_so(self):
        self.assertEqual(note("a" * 1001), "a" * 999 + "…")
        self.assertEqual(note("a" * 200_000), "a" * 999 + "…")
        self.assertEqual(note("😀" * 501), "😀" * 499 + "\ufffd…")
        self.assertEqual(units(note("a" + "😀" * 501)), 1000)

    def test_half_of_a_pair_becomes_the_replacement_character(self):
        self.assertEqual(note("a\ud83d"), "a\ufffd")
        self.assertEqual(note("\ude00b"), "\ufffdb")

    def test_list_of_notes_is_cut_to_100(self):
        notes = Message("HealthReport", **{"remarks": [str(i) for i in range(150)]})["remarks"]
        self.assertEqual(len(notes), 100)
        self.assertEqual(notes[-2:], ("98", "and 51 more"))


if __name__ == "__main__":
    unittest.main()
