"""Variables: validation, all or none, files, undo."""
import json
import os
import pathlib
import tempfile
import unittest
from unittest import mock

from u2sa.configuration import BadConfiguration, Configuration, Variable

VARIABLES = (Variable("GAIN", 0.5, "", 0.0, 1.0), Variable("COUNT", 3, "", 1, 9), Variable("ON", False),
             Variable("MODE", "slow", choices=("slow", "fast")))
TEXT = '<?xml version="1.0"?>\n<configuration>\n  <!-- kept -->\n  <variable name="GAIN" type="double" value="0.25"/>\n' \
       "</configuration>\n"


class ConfigurationTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "Service.xml"
        self.file.write_text(TEXT, encoding="utf-8")
        self.configuration = Configuration(VARIABLES, self.file)

    def audit(self):
        return pathlib.Path(f"{self.file}.audit.jsonl").read_text(encoding="utf-8")

    def test_the_file_says_what_differs_from_the_defaults(self):
        self.assertEqual([self.configuration[name] for name in ("GAIN", "COUNT", "ON")], [0.25, 3, False])

    def test_a_change_is_written_and_read_again(self):
        done = self.configuration.change({"GAIN": "0.75", "ON": "TRUE"}, "anna")
        self.assertEqual(done, [("GAIN", "0.25", "0.75"), ("ON", "false", "true")])
        self.assertIn("<!-- kept -->", self.file.read_text(encoding="utf-8"))
        again = Configuration(VARIABLES, self.file)
        self.assertEqual((again["GAIN"], again["ON"], again.revision), (0.75, True, 1))

    def test_one_wrong_value_changes_nothing(self):
        for wrong, expected in ((("GAIN", "1.5"), "1.5 is outside 0.0…1.0"), (("COUNT", "2.0"), "whole number"),
                                (("GAIN", "nan"), "not a number"), (("ON", "yes"), "neither true nor false"),
                                (("MODE", "quick"), "one of slow, fast"), (("GAIM", "1"), "there is none")):
            with self.subTest(wrong), self.assertRaises(BadConfiguration) as caught:
                self.configuration.change({"COUNT": "4", wrong[0]: wrong[1]}, "anna")
            self.assertIn(expected, str(caught.exception))
        self.assertEqual(self.configuration["COUNT"], 3)
        self.assertEqual(self.file.read_text(encoding="utf-8"), TEXT)

    def test_characters_that_xml_cannot_carry_and_endless_numbers_are_refused(self):
        texts = (*VARIABLES, Variable("LABEL", "a"))
        for name, wrong in (("LABEL", "x\x01y"), ("LABEL", "x\ufffey"), ("LABEL", "\ud800"), ("COUNT", "9" * 5000)):
            with self.subTest(name=name), self.assertRaises(BadConfiguration):
                Configuration(texts, self.file).change({name: wrong}, "anna")
        self.assertEqual(Configuration(texts, self.file)["LABEL"], "a")

    def test_line_separators_in_values_do_not_break_the_audit_log(self):
        texts = (*VARIABLES, Variable("LABEL", "a"))
        for label in ("x\u2028y", "x\u0085y", "x\ny"):
            with self.subTest(label=ascii(label)):
                Configuration(texts, self.file).change({"LABEL": label}, "anna")
                again = Configuration(texts, self.file)
                self.assertEqual(again["LABEL"], label)
                again.undo("anna")
        self.assertEqual(Configuration(texts, self.file).revision, 6)

    def test_comments_outside_the_root_stay(self):
        self.file.write_text(TEXT.replace("<configuration>", "<!-- wiring -->\n<configuration>") + "<!-- end -->\n", encoding="utf-8")
        Configuration(VARIABLES, self.file).change({"COUNT": "4"}, "anna")
        after = self.file.read_text(encoding="utf-8")
        self.assertIn("<!-- wiring -->", after)
        self.assertIn("<!-- end -->", after)

    def test_who_saw_another_revision_changes_nothing(self):
        self.configuration.change({"COUNT": "4"}, "anna", seen=0)
        with self.assertRaises(BadConfiguration) as caught:
            self.configuration.change({"COUNT": "5"}, "ben", seen=0)
        self.assertIn("revision 0 was expected, but it is 1", str(caught.exception))

    def test_undo_goes_back_step_by_step_also_after_a_restart(self):
        self.configuration.change({"COUNT": "4"}, "anna")
        self.configuration.change({"COUNT": "5"}, "anna")
        self.assertEqual(self.configuration.undo("ben"), [("COUNT", "5", "4")])
        again = Configuration(VARIABLES, self.file)
        self.assertEqual(again.undo("ben"), [("COUNT", "4", "3")])
        self.assertEqual(again.revision, 4)
        with self.assertRaises(BadConfiguration):
            again.undo("ben")

    def test_a_write_that_fails_leaves_file_and_values(self):
        with mock.patch.object(os, "replace", side_effect=OSError(28, "No space left on device")):
            with self.assertRaises(BadConfiguration) as caught:
                self.configuration.change({"COUNT": "4"}, "anna")
        self.assertIn("No space left", str(caught.exception))
        self.assertEqual((self.configuration["COUNT"], self.configuration.revision), (3, 0))
        self.assertEqual(self.file.read_text(encoding="utf-8"), TEXT)
        self.assertEqual(sorted(path.name for path in self.file.parent.iterdir()),
                         ["Service.xml", "Service.xml.audit.jsonl"])
        again = Configuration(VARIABLES, self.file)
        self.assertEqual(again.revision, 0)
        with self.assertRaises(BadConfiguration):
            again.undo("anna")

    def test_the_audit_log_has_the_form_of_java(self):
        self.configuration.change({"GAIN": "0.75"}, "anna")
        with self.assertRaises(BadConfiguration):
            self.configuration.change({"GAIN": "7"}, "ben")
        self.configuration.undo("ben")
        lines = [json.loads(line) for line in self.audit().splitlines()]
        self.assertEqual([(line["revision"], line["author"], line["outcome"], line.get("undoes")) for line in lines],
                         [(1, "anna", "ACCEPTED", None), (1, "ben", "REFUSED", None), (2, "ben", "ACCEPTED", 1)])
        self.assertEqual(lines[0]["changes"][0], {
            "variable": "GAIN", "old": "0.25", "new": "0.75", "oldText": "0.25", "newText": "0.75"})
        self.assertIn("7 is outside 0.0…1.0", lines[1]["reason"])
        self.assertRegex(lines[2]["time"], r"^\d{4}-\d\d-\d\dT[\d:.]+Z$")

    def test_a_torn_last_line_is_passed_over(self):
        self.configuration.change({"COUNT": "4"}, "anna")
        with open(f"{self.file}.audit.jsonl", "a", encoding="utf-8") as log:
            log.write('{"revision":2,"time":"2026')
        again = Configuration(VARIABLES, self.file)
        again.change({"COUNT": "5"}, "anna")
        self.assertEqual(Configuration(VARIABLES, self.file).revision, 2)
        self.assertEqual(again.undo("anna"), [("COUNT", "5", "4")])

    def test_what_cannot_be_accounted_for_is_not_done(self):
        pathlib.Path(f"{self.file}.audit.jsonl").mkdir()
        with self.assertRaises(BadConfiguration) as caught:
            self.configuration.change({"COUNT": "4"}, "anna")
        self.assertIn("audit log cannot be written", str(caught.exception))
        self.assertEqual(self.file.read_text(encoding="utf-8"), TEXT)

    def test_files_that_are_none_are_refused(self):
        for text in ("<a/>", "<configuration>", '<!DOCTYPE x [<!ENTITY a "b">]><configuration/>',
                     '<configuration><variable name="GAIN" value="7"/></configuration>',
                     '<configuration><variable name="GAIM" value="7"/></configuration>'):
            self.file.write_text(text, encoding="utf-8")
            with self.subTest(text), self.assertRaises(BadConfiguration):
                Configuration(VARIABLES, self.file)

    def test_a_value_in_another_unit_is_refused(self):
        for name, unit, expected in (("ANGLE", "deg", "0.5 deg: units are not converted here; expected rad"),
                                     ("GAIN", "%", "0.5 %: units are not converted here; expected no unit")):
            self.file.write_text(f'<configuration><variable name="{name}" value="0.5" unit="{unit}"/></configuration>',
                                 encoding="utf-8")
            with self.subTest(name), self.assertRaisesRegex(BadConfiguration, expected):
                Configuration((*VARIABLES, Variable("ANGLE", 0.1, "rad")), self.file)

    def test_a_value_in_the_variables_own_unit_is_taken(self):
        self.file.write_text('<configuration><variable name="ANGLE" value="0.5" unit="rad"/></configuration>',
                             encoding="utf-8")
        self.assertEqual(Configuration((Variable("ANGLE", 0.1, "rad"),), self.file)["ANGLE"], 0.5)

    def test_files_without_end_or_beginning_are_refused(self):
        pipe = self.file.with_name("pipe.xml")
        os.mkfifo(pipe)
        for file in (pipe, pathlib.Path("/dev/zero"), self.file.parent):
            with self.subTest(file), self.assertRaisesRegex(BadConfiguration, "is not a regular file"):
                Configuration(VARIABLES, file)
        self.file.write_text("<configuration>" + " " * 1_000_000, encoding="utf-8")
        with self.assertRaisesRegex(BadConfiguration, "larger than 1000000 characters"):
            Configuration(VARIABLES, self.file)


if __name__ == "__main__":
    unittest.main()
