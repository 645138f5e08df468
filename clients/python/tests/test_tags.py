"""Tags are remarks: readers skip them and read the item behind, but for those of arrays (RFC 8746)."""
import unittest

from u2sa import Malformed, decode

MEANT_FOR_CBOR2 = (0, 1, 2, 3, 4, 5, 25, 28, 29, 30, 35, 36, 37, 52, 54, 100, 256, 258, 260, 261, 1004, 43000, 55799)
ITEMS = ("00", "1bffffffffffffffff", "20", "40", "4101", "60", "617b", "80", "820000", "82 00 c000", "a0", "a1 6161 00",
         "f4", "f6", "f7", "f97e00", "fb7ff0000000000000")


def tagged(tag):
    return "d9%04x" % tag


def unknown(hexadecimal):
    """The value of a field that no table has, of a class that none has."""
    return decode(["Tide"], bytes.fromhex("a1 6171" + hexadecimal)).unknown["q"]


class KeptTest(unittest.TestCase):
    def test_shared_values_are_the_items_behind(self):
        self.assertEqual(unknown("d81c 82 01 d81d00"), [1, 0])  # with a reference to the list that it is in
        self.assertEqual(unknown("82 d81c 81 05 d81d00"), [[5], 0])
        self.assertEqual(unknown("a1 6161 d81c a1 6162 d81d00"), {"a": {"b": 0}})

    def test_string_references_are_the_items_behind(self):
        self.assertEqual(unknown("d90100 83 656162636465 d81900 d81901"), ["abcde", 0, 1])
        self.assertEqual(unknown("d81900"), 0)

    def test_values_are_the_items_behind(self):
        for hexadecimal, expected in (
                ("c0 6161", "a"), ("c1 00", 0), ("c2 420100", b"\x01\x00"), ("c3 40", b""), ("c4 82 01 02", [1, 2]),
                ("d81e 82 01 00", [1, 0]), ("d823 615b", "["), ("d825 40", b""), ("d90102 82 01 01", [1, 1]),
                ("d9d9f7 f5", True), ("d818 4100", b"\x00"), ("d829 82 01 02", [1, 2]), ("c0 c1 d81c 01", 1),
                ("db000000000000001c 01", 1), ("dbffffffffffffffff 01", 1)):
            with self.subTest(hexadecimal):
                self.assertEqual(unknown(hexadecimal), expected)

    def test_a_number_of_many_digits_is_a_byte_string(self):
        self.assertEqual(unknown("c2 590800" + "ff" * 2048), b"\xff" * 2048)

    def test_fields_are_read_from_the_items_behind(self):
        read = decode(["StateInformation"], bytes.fromhex(
            "d9d9f7 a3 6178 c0 01 6a73656e736f724e616d65 c0 6161 6974696d657374616d70 c1 02"))
        self.assertEqual((read["x"], read["sensorName"], read["timestamp"]), (1.0, "a", 2))

    def test_fields_take_no_number_that_a_tag_makes(self):
        for key, value in (("6178", "c2 4101"), ("6974696d657374616d70", "c2 4101"), ("6178", "c4 82 00 01"),
                           ("6178", "d81e 82 01 02")):
            with self.subTest(value), self.assertRaises(Malformed):
                decode(["StateInformation"], bytes.fromhex("a1" + key + value))

    def test_tags_within_and_around_typed_arrays(self):
        for hexadecimal in ("c0 d854 42 003c", "d854 c0 42 003c", "d81c d854 d81d 42 003c"):
            with self.subTest(hexadecimal):
                self.assertEqual(unknown(hexadecimal), [1.0])
        self.assertEqual(unknown("c0 d828 c0 82 c0 82 c0 01 c0 02 c0 d854 c0 44 003c 0040"), [[1.0, 2.0]])

    def test_other_arrays_are_refused(self):
        for tag in ("d840", "d84d", "d857", "d90410"):
            with self.subTest(tag), self.assertRaisesRegex(Malformed, r"Tide\.q: expected a number, text"):
                unknown(tag + "40")

    def test_keys_have_no_tags(self):
        with self.assertRaisesRegex(Malformed, "byte 1: expected a text key or a label"):
            decode(["Tide"], bytes.fromhex("a1 c0 6171 00"))


class SkippedTest(unittest.TestCase):
    def skipped(self, hexadecimal):
        with self.subTest(hexadecimal):
            read = decode(["StateInformation"], bytes.fromhex("a2 6171" + hexadecimal + "6178 01"))
            self.assertEqual((read["x"], len(read.unknown)), (1.0, 0))

    def test_whatever_the_tag_and_its_item(self):
        for tag in MEANT_FOR_CBOR2:
            for item in ITEMS:
                for hexadecimal in (item, "81 " + item, "d856 " + item):
                    self.skipped(tagged(tag) + hexadecimal)

    def test_a_time_that_is_a_number(self):
        self.skipped("c0 00")

    def test_references_to_nothing(self):
        self.skipped("d81d 00")
        self.skipped("d819 00")


class BoundedTest(unittest.TestCase):
    def test_references_multiply_nothing(self):
        thousand = "d81c 9903e8" + "00" * 1000
        payload = "82" + thousand + "990fa0" + "d81d00" * 4000
        first, others = unknown(payload)
        self.assertTrue(first == [0] * 1000 and others == [0] * 4000)  # to print four million would take minutes

    def test_as_many_tags_as_there_are_bytes(self):
        self.assertEqual(unknown("c0" * 1_000_000 + "01"), 1)
        self.assertEqual(len(unknown("9a000186a0" + "c000" * 100_000)), 100_000)


if __name__ == "__main__":
    unittest.main()
