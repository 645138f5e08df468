"""The tables are those of docs/schema/u2sa-messages.json."""
import pathlib
import subprocess
import sys
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[1] / "tools" / "tables.py"


class TablesTest(unittest.TestCase):
    def test_tables_are_those_of_the_schema(self):
        run = subprocess.run([sys.executable, str(TOOL), "--check"], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)


if __name__ == "__main__":
    unittest.main()
