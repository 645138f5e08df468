"""scripts/wire reads the compact encoding too, and takes nothing for it that writers do not write."""
import json
import pathlib
import sys
import unittest

import cbor2

from .test_golden import GOLDEN
from .test_typed import GoldenVectorsTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts" / "wire"))
import decode  # noqa: E402
import rules  # noqa: E402


def with_value(chain, own, key, hexadecimal):
    """A message with all that writers always write, and in one field these bytes."""
    mark = "the bytes stand here"
    given = {**own, key: mark}
    pairs = {name: given.get(name, list(default) if isinstance(default, tuple) else default)
             for name, _kind, presence, default, *_ in rules.MESSAGES[chain[-1]][2] if presence != "optional" or name in given}
    return cbor2.dumps(pairs).replace(cbor2.dumps(mark), bytes.fromhex(hexadecimal))


class ScriptsTest(unittest.TestCase):
    def hold(self, chain, payload):
        message, _origin = rules.parts(payload)
        rules.fields_of(chain, message, "")

    def report(self, hexadecimal, key="finished"):
        self.hold(["MissionReport"], with_value(["MissionReport"], {"requestId": "r", "serviceName": "s"}, key, hexadecimal))

    def path(self, hexadecimal, key="points"):
        self.hold(["PlannedPath"], with_value(["PlannedPath"], {"planner": "p", "status": "FOLLOWED"}, key, hexadecimal))

    def differs(self, hold, hexadecimal, expected, key):
        with self.subTest(hexadecimal[:60]), self.assertRaisesRegex(rules.Difference, expected):
            hold(hexadecimal, key)

    def test_every_vector_in_the_compact_encoding_is_its_json_and_as_writers_write(self):
        for file in sorted(GOLDEN.rglob("*.cbor")):
            with self.subTest(file.name):
                said = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))
                payload = cbor2.dumps(GoldenVectorsTest().compact(cbor2.loads(file.read_bytes())))
                self.assertEqual(decode.differences(said["message"], decode.decode(payload), file.stem), [])
                self.hold(said["typeChain"], payload)
                self.hold(said["typeChain"], file.read_bytes())

    def test_decode_reads_every_float_and_byte_order(self):
        for value in ("d850 44 3e00 c000", "d851 48 3fc00000 c0000000", "d852 50 3ff8000000000000 c000000000000000",
                      "d854 44 003e 00c0", "d855 48 0000c03f 000000c0", "d856 50 000000000000f83f 00000000000000c0"):
            with self.subTest(value):
                self.assertEqual(decode.decode(bytes.fromhex("a1 6178" + value)), {"x": [1.5, -2.0]})
                self.assertEqual(decode.decode(bytes.fromhex("a1 6178 d828 82 820201" + value)), {"x": [[1.5], [-2.0]]})

    def test_decode_refuses_what_is_no_list(self):
        for value in ("d856 41 00", "d856 80", "d828 00", "d828 82 820103 d856 40", "d828 82 820003 d857 40", "d828 82 820000 80",
                      "d854 42 007e", "d828 82 820101 d854 42 007e"):
            with self.subTest(value), self.assertRaises(ValueError):
                decode.decode(bytes.fromhex("a1 6178" + value))

    def test_rules_take_what_writers_write(self):
        for value in ("80", "d856 40", "d856 48 000000000000f03f"):
            self.report(value)
        for value in ("80", "d828 82 820003 d856 40", "d828 82 820103 d856 5818" + "00" * 24):
            self.path(value)

    def test_rules_take_no_other_typed_arrays(self):
        for tag in ("d850", "d851", "d852", "d854", "d855", "d857", "d840"):
            self.differs(self.report, tag + "40", "none that writers write", "finished")
            self.differs(self.path, "d828 82 820003" + tag + "40", "no tag 86", "points")
        self.differs(self.path, "d828 82 820003 80", "no tag 86", "points")

    def test_rules_take_no_longer_form(self):
        for value in ("d90056 40", "d856 5800", "d856 5f ff"):
            self.differs(self.report, value, "not as writers write", "finished")
        for value in ("d828 82 82001803 d856 40", "d828 9f 820003 d856 40 ff", "d828 82 9f0003ff d856 40"):
            self.differs(self.path, value, "not as writers write", "points")

    def test_rules_take_no_other_shape(self):
        self.differs(self.report, "d856 41 00", "no tag 86 on a byte string of float64", "finished")
        self.differs(self.report, "d856 48 000000000000f07f", "no finite float64", "finished")
        self.differs(self.path, "d828 82 820003 d856 48" + "00" * 8, "no tag 86", "points")
        for dimensions in ("820103", "820004", "8100", "82f403", "82fb000000000000000003"):
            self.differs(self.path, "d828 82" + dimensions + "d856 40", "dimensions", "points")
        self.differs(self.path, "d828 83 820003 d856 40 00", "not dimensions and numbers", "points")

    def test_rules_take_them_in_their_own_fields_only(self):
        self.differs(self.path, "d856 40", "no array of points", "points")
        self.differs(self.report, "d828 82 820003 d856 40", "no array of numbers", "finished")
        self.differs(self.report, "d856 40", "no array of texts", "current")
        self.differs(self.report, "d828 82 820003 d856 40", "no array of messages", "goals")


if __name__ == "__main__":
    unittest.main()
