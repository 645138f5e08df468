"""Tests of the Python client; they never read the account's real tokens."""
import os
import tempfile

if not os.environ.get("U2SA_ACCOUNT_FOLDER"):
    os.environ["U2SA_ACCOUNT_FOLDER"] = os.path.join(tempfile.gettempdir(), f"u2sa-tests-{os.getpid()}")  # never created
