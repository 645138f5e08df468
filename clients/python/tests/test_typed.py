"""Lists of numbers and points as typed arrays (RFC 8746), as the compact encoding has them."""
import json
import struct
import unittest

import cbor2

from u2sa import Malformed, decode, encode, tables
from u2sa.schema import STANDARD

from .test_golden import GOLDEN

REPORT = b"\xa3\x69requestId\x61r\x6bserviceName\x61s\x68finished"
PATH = b"\xa3\x67planner\x61p\x66status\x68FOLLOWED\x66points"
LINE = b"\xa1\x64line"  # a field that no table has, of a class that none has
ONE_TO_SIX = [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)]
IN_FLOAT16 = {"big": "3c00 4000 4200 4400 4500 4600", "little": "003c 0040 0042 0044 0045 0046"}


def finished(value):
    return decode(["MissionReport"], REPORT + value)["finished"]


def points(value):
    return decode(["PlannedPath"], PATH + value)["points"]


def line(value):
    return decode(["Tide"], LINE + value).unknown["line"]


class TypedArrayTest(unittest.TestCase):
    def assert_numbers(self, hexadecimal, *expected):
        read = finished(bytes.fromhex(hexadecimal))
        self.assertEqual(read, expected)
        self.assertEqual({type(item) for item in read}, {float} if expected else set())

    def test_floats_of_16_bits_big_endian(self):
        self.assert_numbers("d850 44 3e00 c000", 1.5, -2.0)

    def test_floats_of_32_bits_big_endian(self):
        self.assert_numbers("d851 48 3fc00000 c0000000", 1.5, -2.0)

    def test_floats_of_64_bits_big_endian(self):
        self.assert_numbers("d852 50 3ff8000000000000 c000000000000000", 1.5, -2.0)

    def test_floats_of_16_bits_little_endian(self):
        self.assert_numbers("d854 44 003e 00c0", 1.5, -2.0)

    def test_floats_of_32_bits_little_endian(self):
        self.assert_numbers("d855 48 0000c03f 000000c0", 1.5, -2.0)

    def test_floats_of_64_bits_little_endian(self):
        self.assert_numbers("d856 50 000000000000f83f 00000000000000c0", 1.5, -2.0)

    def test_empty_ones(self):
        for tag in ("d850", "d851", "d852", "d854", "d855", "d856"):
            with self.subTest(tag):
                self.assert_numbers(tag + "40")

    def test_a_plain_array_as_before(self):
        self.assert_numbers("82 f93e00 21", 1.5, -2.0)

    def test_lengths_and_tags_that_are_longer_than_need_be_and_pieces(self):
        self.assert_numbers("d90056 5800")
        self.assert_numbers("d854 5a00000002 003e", 1.5)
        self.assert_numbers("d854 5f 4100 413e 420040 ff", 1.5, 2.0)

    def test_as_many_as_a_list_may_have_and_no_more(self):
        self.assertEqual(len(finished(b"\xd8\x54\x5a" + struct.pack(">I", 200_000) + bytes(200_000))), 100_000)
        with self.assertRaisesRegex(Malformed, r"MissionReport\.finished: expected at most 100000 elements, not 100001"):
            finished(b"\xd8\x54\x5a" + struct.pack(">I", 200_002) + bytes(200_002))


class PointsTest(unittest.TestCase):
    def test_floats_of_64_bits_little_endian_as_they_are_written(self):
        self.assertEqual(points(bytes.fromhex("d828 82 820203 d856 5830" + "000000000000f03f 0000000000000040 0000000000000840"
                                              + "0000000000001040 0000000000001440 0000000000001840")), tuple(ONE_TO_SIX))

    def test_every_other_float(self):
        for tag, order, element in (("d850", ">", "e"), ("d851", ">", "f"), ("d852", ">", "d"),
                                    ("d854", "<", "e"), ("d855", "<", "f")):
            with self.subTest(tag):
                data = struct.pack(order + "6" + element, 1, 2, 3, 4, 5, 6)
                head = bytes.fromhex("d828 82 820203" + tag) + bytes([0x58, len(data)])
                self.assertEqual(points(head + data), tuple(ONE_TO_SIX))

    def test_both_endiannesses_by_hand(self):
        self.assertEqual(points(bytes.fromhex("d828 82 820203 d850 4c" + IN_FLOAT16["big"])), tuple(ONE_TO_SIX))
        self.assertEqual(points(bytes.fromhex("d828 82 820203 d854 4c" + IN_FLOAT16["little"])), tuple(ONE_TO_SIX))

    def test_a_plain_array_of_coordinates(self):
        self.assertEqual(points(bytes.fromhex("d828 82 820203 86 01 02 03 f94400 fa40a00000 06")), tuple(ONE_TO_SIX))
        self.assertEqual(points(bytes.fromhex("d828 9f 9f0203ff 9f 010203040506 ff ff")), tuple(ONE_TO_SIX))

    def test_plain_points_as_before(self):
        self.assertEqual(points(bytes.fromhex("82 83010203 83040506")), tuple(ONE_TO_SIX))

    def test_empty_ones(self):
        for data in ("d856 40", "d850 40", "80"):
            with self.subTest(data):
                self.assertEqual(points(bytes.fromhex("d828 82 820003" + data)), ())

    def test_within_a_message_of_a_list(self):
        goals = b"\xa1\x67objects\x81\xa5\x64type\x82\x71ObjectDescription\x6aPointCloud\x63uid\x61a\x61x\x01\x61y\x02\x66points"
        read = decode(["ObjectList"], goals + bytes.fromhex("d828 82 820203 d854 4c" + IN_FLOAT16["little"]))
        self.assertEqual(read["objects"][0]["points"], tuple(ONE_TO_SIX))

    def test_more_points_than_numbers_in_a_list(self):
        read = points(bytes.fromhex("d828 82 82 1a000186a0 03 d854 5a000927c0") + bytes(600_000))
        self.assertEqual((len(read), read[-1]), (100_000, (0.0, 0.0, 0.0)))


class RefusedTest(unittest.TestCase):
    def refused(self, read, hexadecimal, expected):
        with self.subTest(hexadecimal[:60]), self.assertRaises(Malformed) as caught:
            read(bytes.fromhex(hexadecimal))
        self.assertIn(expected, str(caught.exception))

    def test_what_is_not_finite(self):
        for hexadecimal in ("d850 42 7e00", "d850 42 7c00", "d851 44 7fc00000", "d851 44 ff800000", "d852 48 7ff8000000000000",
                            "d854 42 007e", "d854 42 00fc", "d855 44 0000c07f", "d856 48 000000000000f87f",
                            "d856 48 000000000000f07f", "d856 48 000000000000f0ff"):
            self.refused(finished, hexadecimal, "MissionReport.finished: expected a finite number")
        self.refused(points, "d828 82 820103 d854 46 0000 007e 0000", "PlannedPath.points: expected a finite number")
        self.refused(points, "d828 82 820103 83 00 f97c00 00", "PlannedPath.points: expected a finite number")
        self.refused(line, "d854 42 007e", "Tide.line: expected a finite number")
        self.refused(line, "d828 82 820101 d854 42 007e", "Tide.line: expected a finite number")

    def test_lengths_that_are_no_multiple_of_an_element(self):
        for tag, size, name in (("d850", 2, "float16"), ("d851", 4, "float32"), ("d852", 8, "float64"),
                                ("d854", 2, "float16"), ("d855", 4, "float32"), ("d856", 8, "float64")):
            for length in (size - 1, size + 1):
                data = f"{tag} 4{length:x}" + "00" * length
                expected = f": expected a byte string of whole {name}, not {length} bytes"
                self.refused(finished, data, "MissionReport.finished" + expected)
                self.refused(points, "d828 82 820003" + data, "PlannedPath.points" + expected)
                self.refused(line, data, "Tide.line" + expected)

    def test_what_is_no_byte_string(self):
        for value, name in (("80", "float64, not "), ("6161", "float64, not str"), ("00", "float64, not int"),
                            ("d856 40", "float64, not CBORTag")):
            self.refused(finished, "d856" + value, "MissionReport.finished: expected a byte string of whole " + name)

    def test_other_typed_arrays_and_tags(self):
        for tag in ("d840", "d841", "d844", "d848", "d84e", "d84f", "d853", "d857", "d90410"):
            number = int(tag[2:], 16)
            of_floats = f": expected an array, or a typed array of float16, 32 or 64, not tag {number}"
            self.refused(finished, tag + "50" + "00" * 16, "MissionReport.finished" + of_floats)
            self.refused(points, "d828 82 820003" + tag + "40", "PlannedPath.points" + of_floats)
            self.refused(points, tag + "50" + "00" * 16,
                         f"PlannedPath.points: expected an array of points or tag 40, not tag {number}")
            self.refused(line, tag + "50" + "00" * 16, "Tide.line: expected a number, text")

    def test_the_one_in_place_of_the_other(self):
        self.refused(finished, "d828 82 820003 d856 40", "MissionReport.finished: expected an array, or a typed array")
        self.refused(points, "d856 40", "PlannedPath.points: expected an array of points or tag 40, not tag 86")
        self.refused(points, "81 d854 46 003c 0040 0042", "PlannedPath.points: expected an array, not CBORTag(84")
        self.refused(finished, "81 d854 42 003c", "MissionReport.finished: expected a number, not CBORTag(84")

    def test_dimensions_that_are_none_of_points(self):
        for dimensions in ("820204", "820302", "820206", "8106", "83020301", "80", "06", "822103", "82f5f5", "82f9400003",
                           "826132 03", "d84042 0203"):
            self.refused(points, "d828 82" + dimensions + "d854 4c" + IN_FLOAT16["little"],
                         "PlannedPath.points: expected the dimensions [n, 3] of at most 100000 elements")

    def test_dimensions_that_do_not_match_the_numbers(self):
        for rows, data in ((1, "d854 4c" + IN_FLOAT16["little"]), (3, "d854 4c" + IN_FLOAT16["little"]), (0, "d854 42 0000"),
                           (1, "d856 40"), (1, "82 0102"), (2, "83 010203"), (0, "81 00")):
            self.refused(points, f"d828 82 82{rows:02x}03" + data, f"PlannedPath.points: expected {rows} times 3 numbers, not ")

    def test_what_is_no_pair_of_dimensions_and_numbers(self):
        for value in ("00", "40", "6161", "80", "81 820003", "83 820003 d85640 00"):
            self.refused(points, "d828" + value, "PlannedPath.points: expected an array of dimensions and numbers behind tag 40")
        self.refused(points, "d828 82 820003 40", "PlannedPath.points: expected an array, not b''")
        self.refused(points, "d828 82 820103 83 01 02 6133", "PlannedPath.points: expected a number, not '3'")
        self.refused(points, "d828 82 820103 83 01 02 f5", "PlannedPath.points: expected a number, not True")

    def test_more_points_than_a_list_may_have(self):
        self.refused(points, "d828 82 82 1a000186a1 03 d854 5a000927c6" + "00" * 600_006, "at most 100000 elements, not")
        self.refused(points, "d828 82 82 1bffffffffffffffff 03 d856 40", "at most 100000 elements, not")

    def test_a_typed_array_where_no_list_of_numbers_is(self):
        self.refused(lambda value: decode(["StateInformation"], b"\xa1\x61x" + value), "d856 48 000000000000f03f",
                     "StateInformation.x: expected a number")
        self.refused(lambda value: decode(["GoalInformation", "Waypoint"], b"\xa2\x63uid\x61a\x64next" + value), "d856 40",
                     "Waypoint.next: expected an array")
        self.refused(lambda value: decode(["RangeScan"], b"\xa1\x67returns" + value), "d856 40",
                     "RangeScan.returns: expected an array")


class UnknownTest(unittest.TestCase):
    def test_a_typed_array_is_a_list_of_floats(self):
        for hexadecimal in ("d850 44 3e00 c000", "d851 48 3fc00000 c0000000", "d852 50 3ff8000000000000 c000000000000000",
                            "d854 44 003e 00c0", "d855 48 0000c03f 000000c0", "d856 50 000000000000f83f 00000000000000c0"):
            with self.subTest(hexadecimal):
                self.assertEqual(line(bytes.fromhex(hexadecimal)), [1.5, -2.0])
        self.assertEqual(line(bytes.fromhex("d856 40")), [])

    def test_two_dimensions_are_a_list_of_lists_of_floats(self):
        six = "d854 4c" + IN_FLOAT16["little"]
        self.assertEqual(line(bytes.fromhex("d828 82 820302" + six)), [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
        self.assertEqual(line(bytes.fromhex("d828 82 820601" + six)), [[1.0], [2.0], [3.0], [4.0], [5.0], [6.0]])
        self.assertEqual(line(bytes.fromhex("d828 82 820106" + six)), [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]])
        self.assertEqual(line(bytes.fromhex("d828 82 820005 d856 40")), [])
        plain = line(bytes.fromhex("d828 82 820102 82 01 f94000"))
        self.assertEqual(plain, [[1.0, 2.0]])
        self.assertEqual({type(item) for item in plain[0]}, {float})

    def test_within_lists_and_maps(self):
        self.assertEqual(line(bytes.fromhex("82 a1 6161 d854 42 003c d854 42 0040")), [{"a": [1.0]}, [2.0]])

    def test_dimensions_that_are_none_of_a_list_of_lists(self):
        for value in ("820600", "820000", "8106", "83010203", "822102", "82 01 1bffffffffffffffff"):
            with self.subTest(value), self.assertRaisesRegex(Malformed, r"Tide\.line: expected the dimensions \[n, m\]"):
                line(bytes.fromhex("d828 82" + value + "d854 4c" + IN_FLOAT16["little"]))

    def test_more_elements_than_a_list_may_have(self):
        for value in ("d854 5a00030d42" + "00" * 200_002, "d828 82 82 1a000186a1 01 d854 5a00030d42" + "00" * 200_002,
                      "d828 82 82 01 1a000186a1 d854 5a00030d42" + "00" * 200_002):
            with self.subTest(value[:40]), self.assertRaisesRegex(Malformed, r"Tide\.line: .*at most 100000 elements, not"):
                line(bytes.fromhex(value))

    def test_a_newer_subclass_relays_them_as_plain_lists(self):
        read = decode(["GoalCommand", "DiveCommand"], b"\xa2\x63uid\x61a\x65depth\xd8\x54\x42\x00\x3c")
        self.assertEqual(encode(read), b"\xa2\x63uid\x61a\x65depth\x81\xfb\x3f\xf0\0\0\0\0\0\0")

    def test_whatever_a_skipped_field_has(self):
        for hexadecimal in ("d856 41 00", "d854 42 007e", "d857 40", "d828 00", "d828 82 820203 d856 40"):
            with self.subTest(hexadecimal):
                self.assertEqual(decode(["StateInformation"], b"\xa2\x61q" + bytes.fromhex(hexadecimal) + b"\x61x\x01")["x"], 1.0)


class GoldenVectorsTest(unittest.TestCase):
    LABELS = {name: label for label, name in enumerate(tables.LABELS)}
    KINDS = {field.name: field.kind for name in STANDARD.names() for field in STANDARD.type(name).fields}

    def compact(self, value, name=None):
        if isinstance(value, dict):
            return {self.LABELS.get(key, key): self.compact(item, key) for key, item in value.items()}
        if not isinstance(value, list):
            return value
        if self.KINDS.get(name) == "numbers":
            return cbor2.CBORTag(86, struct.pack(f"<{len(value)}d", *value))
        if self.KINDS.get(name) == "points":
            flat = [coordinate for point in value for coordinate in point]
            return cbor2.CBORTag(40, [[len(value), 3], cbor2.CBORTag(86, struct.pack(f"<{len(flat)}d", *flat))])
        return [self.compact(item) for item in value]

    def test_every_vector_in_the_compact_encoding_is_the_same_message(self):
        typed = 0
        for file in sorted(GOLDEN.rglob("*.cbor")):
            with self.subTest(file.name):
                chain = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))["typeChain"]
                payload = cbor2.dumps(self.compact(cbor2.loads(file.read_bytes())))
                typed += b"\xd8\x56" in payload
                self.assertEqual(encode(decode(chain, payload)), file.read_bytes())
        self.assertGreater(typed, 5)


if __name__ == "__main__":
    unittest.main()
