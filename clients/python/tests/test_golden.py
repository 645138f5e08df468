"""The golden vectors of every format, read and written byte for byte."""
import base64
import dataclasses
import json
import pathlib
import unittest

import cbor2

from u2sa import Malformed, Message, Schema, decode, encode, tables
from u2sa.message import UnknownConstant
from u2sa.schema import STANDARD

GOLDEN = pathlib.Path(__file__).resolve().parents[3] / "docs" / "wire" / "golden"


def plain(value):
    """A message's value as its JSON says it."""
    if isinstance(value, Message):
        return {"type": list(value.chain), **{key: plain(item) for key, item in value.items()}}
    if isinstance(value, bytes):
        return base64.b64encode(value).decode("ascii")
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return value


class GoldenTest(unittest.TestCase):
    def test_every_vector_is_read_and_written_byte_for_byte(self):
        files = sorted(GOLDEN.rglob("*.cbor"))
        self.assertGreater(len(files), 50)
        for file in files:
            with self.subTest(file.name):
                said = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))
                message = decode(said["typeChain"], file.read_bytes())
                self.assertEqual(encode(message), file.read_bytes())
                self.assertEqual({key: plain(value) for key, value in message.items()}, said["message"])
                self.assertEqual([key for key, _ in message.items()], list(said["message"]))


class LabelsTest(unittest.TestCase):
    """Fields named by numbers, as WIRE FORM = compact has them written."""

    LABELS = {name: label for label, name in enumerate(tables.LABELS)}

    def labelled(self, value):
        if isinstance(value, dict):
            return {self.LABELS.get(key, key): self.labelled(item) for key, item in value.items()}
        return [self.labelled(item) for item in value] if isinstance(value, list) else value

    def test_every_vector_with_labels_is_the_same_message(self):
        for file in sorted(GOLDEN.rglob("*.cbor")):
            with self.subTest(file.name):
                chain = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))["typeChain"]
                payload = cbor2.dumps(self.labelled(cbor2.loads(file.read_bytes())))
                self.assertLess(len(payload), file.stat().st_size)
                self.assertEqual(encode(decode(chain, payload)), file.read_bytes())

    def test_labels_that_nobody_knows_are_skipped_or_shown(self):
        self.assertEqual(decode(["StateInformation"], bytes.fromhex("a2 1903e8 07 06 f93e00"))["x"], 1.5)
        self.assertEqual(decode(["Tide"], bytes.fromhex("a1 1903e8 07")).unknown, {"#1000": 7})

    def test_a_field_by_name_and_by_label_is_refused(self):
        for hexadecimal in ("a2 06 f93e00 6178 f93e00", "a2 06 f93e00 1806 f93e00", "a2 06 f93e00 622336 f93e00"):
            with self.subTest(hexadecimal), self.assertRaisesRegex(Malformed, "comes twice"):
                decode(["StateInformation"], bytes.fromhex(hexadecimal))


class HostileBytesTest(unittest.TestCase):
    def refused(self, chain, hexadecimal, expected):
        with self.assertRaises(Malformed) as caught:
            decode(chain.split("/"), bytes.fromhex(hexadecimal))
        self.assertIn(expected, str(caught.exception))

    def test_what_is_no_message_is_refused(self):
        for hexadecimal, expected in (
                ("", "cut short"), ("a0a0", "expected the end"), ("80", "expected a map"), ("ff", "break"),
                ("a1617861 79", "expected a number"), ("a16178f6", "expected a number"),
                ("a16178f97e00", "finite"), ("a16178fb7ff0000000000000", "finite"),
                ("a26178fb00000000000000006178fb0000000000000000", "comes twice"), ("a2617100617100", "comes twice"),
                ("a2617100 7f6171ff00", "comes twice"), ("a161718181818181818181818181818181", "levels"),
                ("a16a73656e736f724e616d657b00000001ffffffff", "at most"), ("bbffffffffffffffff", "cut short"),
                ("a16a73656e736f724e616d6563edb9bb", "CBOR"), ("a120f6", "text key"),
                ("a16974696d657374616d70c249ffffffffffffffffff", "64 bits"),
                ("a16178c2588101" + "00" * 128, "x: expected a number, not b'")):
            with self.subTest(hexadecimal):
                self.refused("StateInformation", hexadecimal, expected)

    def test_array_tags_within_each_other_are_skipped_and_bounded(self):
        self.assertEqual(decode(["StateInformation"], bytes.fromhex("a2 6171" + "d856" * 8 + "00 6178 01"))["x"], 1.0)
        for tags in (9, 500, 100_000):
            self.refused("StateInformation", "a2 6171" + "d856" * tags + "00 6178 01", "byte 3: more than 8 array tags of one item")
        self.refused("StateInformation", "a1 6171 d856 ff", "break")
        self.refused("StateInformation", "a1 6171 d856", "cut short")

    def test_a_required_field_that_is_missing_is_named(self):
        self.refused("GoalCommand", "a0", "GoalCommand.uid is required")

    def test_a_list_of_the_wrong_kind_is_refused(self):
        self.refused("GoalList", "a165676f616c7381a16474797065816f4f626a6563744465736372697074696f6e"
                     .replace("6f4f", "714f"), "required")
        self.refused("GoalList", "a165676f616c7381a0", '"type" as the first key')

    def test_byte_strings_are_taken_whole_or_in_pieces_and_bounded(self):
        image = "a3 6a73656e736f724e616d65 6143 66666f726d6174 6170 6464617461"
        self.assertEqual(decode(["CameraImage"], bytes.fromhex(image + "4201ff"))["data"], b"\x01\xff")
        self.assertEqual(decode(["CameraImage"], bytes.fromhex(image + "5f41014101 ff"))["data"], b"\x01\x01")
        self.refused("CameraImage", image + "6101", "CameraImage.data: expected a byte string")
        self.refused("CameraImage", image + "5a000f0001", "cut short")
        self.refused("CameraImage", image + "5a000f0001" + "00" * ((15 << 16) + 1), "at most 983040 bytes")
        self.refused("CameraImage", image + "5bffffffffffffffff", "at most")

    def test_shorter_floats_and_indefinite_lengths_are_taken(self):
        read = decode(["StateInformation"], bytes.fromhex("bf6178f93e006179fa3fc00000617a02ff"))
        self.assertEqual((read["x"], read["y"], read["z"]), (1.5, 1.5, 2.0))


class OriginTest(unittest.TestCase):
    def test_origin_stands_behind_the_message_and_is_no_part_of_it(self):
        payload = (GOLDEN.parent / "origin.cbor").read_bytes()
        read = decode(["StopCommand"], payload)
        self.assertEqual(read.origin, ("1f0c", 17))
        self.assertEqual(encode(read, ("1f0c", 17)), payload)
        self.assertNotIn("origin", dict(decode(["Tide"], payload).items()))


class OtherVersionsTest(unittest.TestCase):
    def test_an_unknown_subclass_is_its_ancestor_and_keeps_the_rest(self):
        payload = bytes.fromhex("a3") + b"\x63uid\x61a" + b"\x65depth\x03" + b"\x64tags\x82\x61x\xf5"
        read = decode(["GoalCommand", "DiveCommand"], payload)
        self.assertTrue(read.is_a("GoalCommand"))
        self.assertEqual((read["uid"], read.get("depth"), read.get("tags")), ("a", 3, ["x", True]))
        self.assertEqual(encode(read), payload)

    def test_a_class_without_known_ancestor_keeps_all(self):
        read = decode(["Tide"], bytes.fromhex("a16668656967687404"))
        self.assertIsNone(read.type)
        self.assertEqual(read.get("height"), 4)

    def test_an_unknown_constant_is_absent_where_optional_and_refused_where_required(self):
        shape = b"\xa4\x63uid\x61a\x61x\x01\x61y\x02\x65level\x64SOFT"
        self.assertNotIn("level", decode(["ObjectDescription"], shape))
        order = b"\xa3\x69requestId\x61r\x6bserviceName\x61s\x66action\x65PAUSE"
        with self.assertRaises(UnknownConstant):
            decode(["ServiceOrder"], order)


class OldReaderTest(unittest.TestCase):
    """A client of format 1: it has that format's classes and fields only."""

    def setUp(self):
        released = {line.split()[1] for line in (GOLDEN / "format-1.sha256").read_text(encoding="utf-8").splitlines()}
        names = {json.loads((GOLDEN / file).read_text(encoding="utf-8"))["typeChain"][-1]
                 for file in released if file.endswith(".json")} | {"GoalInformation", "ShapeDescription"}
        self.old = Schema({name: dataclasses.replace(STANDARD.type(name), fields=tuple(
            field for field in STANDARD.type(name).fields if field.since == 1)) for name in names})

    def test_every_message_is_read_as_its_class_or_nearest_ancestor(self):
        newer = 0
        for file in sorted(GOLDEN.glob("*.cbor")):
            said = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))
            chain = said["typeChain"]
            with self.subTest(file.name):
                read = decode(chain, file.read_bytes(), self.old)
                nearest = [name for name in chain if name in self.old.names()]
                self.assertEqual(read.type.name if read.type else None, nearest[-1] if nearest else None)
                self.assertEqual(list(read.chain), chain)
                if not nearest or nearest[-1] != chain[-1]:
                    newer += 1
                    relayed = encode(read)  # whole; in another order where an ancestor has new fields
                    self.assertEqual(len(relayed), len(file.read_bytes()))
                    self.assertEqual(plain(decode(chain, relayed)), plain(decode(chain, file.read_bytes())))
        self.assertGreater(newer, 15)

    def test_added_fields_are_skipped_and_a_newer_subclass_is_its_parent(self):
        report = decode(["HealthReport"], (GOLDEN / "HealthReport-2.cbor").read_bytes(), self.old)
        self.assertNotIn("interval", report)
        lost = decode(["HealthReport", "ConnectionLost"], (GOLDEN / "ConnectionLost-will.cbor").read_bytes(), self.old)
        self.assertEqual((lost.type.name, lost["status"], lost.get("instance")), ("HealthReport", "FAILED", lost.unknown["instance"]))


class MessageTest(unittest.TestCase):
    def test_values_are_checked_as_they_are_set(self):
        command = Message("PercentageCommand", actuatorName="AILERON")
        for wrong in (100.5, float("nan"), True, "1", None):
            with self.assertRaises(Malformed):
                command["percentage"] = wrong
        with self.assertRaises(KeyError):
            command["percent"] = 1.0
        with self.assertRaises(ValueError):
            encode(command)

    def test_abstract_classes_cannot_be_made(self):
        with self.assertRaises(ValueError):
            Message("GoalInformation", uid="1")


if __name__ == "__main__":
    unittest.main()
