"""What a connection does with what the broker refused or did not confirm."""
import os
import pathlib
import tempfile
import threading
import types
import unittest
from unittest import mock

from u2sa import link
from u2sa.link import Broker, Link, local_token, token_folders


def sent(topic, retain):
    return types.SimpleNamespace(topic=topic, retain=retain)


class FakeClient:
    """As much of paho's client as the connection touches, in 1.6 and 2.x alike."""

    def __init__(self):
        self._out_message_mutex = threading.Lock()
        self._out_messages = {1: sent("u2sa/cessna/stop/StopCommand", False), 2: sent("u2sa/cessna/goals/GoalList", True)}
        self._inflight_messages = 2

    def subscribe(self, topic_filter, _quality):
        return 0, 7


class LinkTest(unittest.TestCase):
    def setUp(self):
        self.troubles = []
        self.link = Link(Broker(), "cessna", "Motor", lambda *_: None, self.troubles.append)
        self.link._client = self.client = FakeClient()

    def test_a_lost_connection_drops_what_was_not_confirmed_but_for_retained_topics(self):
        self.link._retained.unconfirmed = lambda topics: self.troubles.append(tuple(topics))
        self.link._disconnected(self.client, None, 7)
        self.assertEqual(self.client._out_messages, {})
        self.assertEqual(self.client._inflight_messages, 0)
        self.assertEqual(self.troubles, [("u2sa/cessna/goals/GoalList",), "connection lost: 7"])

    def test_a_refused_subscription_is_told_once_and_known_by_its_channel(self):
        for _ in range(2):
            self.link.subscribe("u2sa/cessna/emergency-stop/#")
            self.link._subscribed(self.client, None, 7, [0x80])
        self.assertEqual(self.link.refused_channels(), ["emergency-stop"])
        self.assertEqual(len(self.troubles), 1)

    def test_a_subscription_granted_later_is_no_longer_refused(self):
        for code in (0x80, 1):
            self.link.subscribe("u2sa/cessna/emergency-stop/#")
            self.link._subscribed(self.client, None, 7, [code])
        self.assertEqual(self.link.refused_channels(), [])


class ConnectingTest(unittest.TestCase):
    def link(self, refusals, error=ConnectionRefusedError(111, "Connection refused")):
        """A link whose broker refuses so often, and the clock that its waits advance."""
        self.troubles, self.now, self.left = [], 0.0, refusals
        made = Link(Broker(port=1), "cessna", "Motor", lambda *_: None, self.troubles.append)
        made._client = types.SimpleNamespace(loop_start=made._answered.set, loop_stop=lambda: None, disconnect=lambda: None)

        def connect():
            self.left -= 1
            if self.left >= 0:
                raise error

        def sleep(seconds):
            self.now += seconds

        made._connect = connect
        for each in (mock.patch.object(link.time, "monotonic", lambda: self.now), mock.patch.object(link.time, "sleep", sleep)):
            each.start()
            self.addCleanup(each.stop)
        return made

    def test_a_broker_that_listens_later_is_awaited_and_told_once(self):
        self.link(5).open(patience_s=30.0)
        self.assertEqual(self.troubles, ["no Communication Manager at localhost:1 yet; trying for 30 s"])

    def test_a_broker_that_never_listens_is_given_up_in_one_line_without_a_cause(self):
        with self.assertRaisesRegex(link.CannotConnect, "^no Communication Manager at localhost:1 after 2 s: .*refused") as given_up:
            self.link(1000).open(patience_s=2.0)
        self.assertTrue(given_up.exception.__suppress_context__)
        self.assertGreaterEqual(self.now, 2.0)

    def test_an_address_that_is_none_is_not_awaited(self):
        with self.assertRaises(link.CannotConnect):
            self.link(1000, OSError("Name or service not known")).open(patience_s=30.0)
        self.assertEqual((self.troubles, self.now), ([], 0.0))

    def test_an_address_names_host_and_port(self):
        self.assertEqual(Broker.at("localhost:18830"), Broker("localhost", 18830))
        self.assertEqual(Broker.at("rover"), Broker("rover", 1883))
        self.assertEqual(Broker.at("[::1]:1884"), Broker("::1", 1884))
        for wrong in ("", ":1883", "rover:", "rover:0", "rover:70000", "tcp://rover:1883", "a b"):
            with self.assertRaisesRegex(ValueError, "expected HOST or HOST:PORT"):
                Broker.at(wrong)


@unittest.skipIf(os.name == "nt", "POSIX permissions")
class TokenTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.runtime = pathlib.Path(scratch.name, "runtime")
        self.home = pathlib.Path(scratch.name, "home")
        account = types.SimpleNamespace(pw_dir=str(self.home))
        for each in (mock.patch.dict(os.environ, {"HOME": str(self.home), "XDG_RUNTIME_DIR": str(self.runtime), "U2SA_ACCOUNT_FOLDER": ""}),
                     mock.patch.object(link, "pwd", types.SimpleNamespace(getpwuid=lambda _uid: account))):
            each.start()
            self.addCleanup(each.stop)
        for folder in (self.runtime / "u2sa", self.home / ".u2sa" / "run"):
            folder.mkdir(mode=0o700, parents=True)
        self.runtime.chmod(0o700)

    def write(self, folder, token, seconds):
        file = folder / "broker-1883.token"
        file.write_text(token + "\n", encoding="utf-8")
        file.chmod(0o600)
        os.utime(file, (seconds, seconds))

    def test_the_newest_token_of_all_folders_is_used(self):
        self.assertEqual(local_token("127.0.0.1", 1883)[0], None)
        self.write(self.home / ".u2sa" / "run", "home", 1000)
        self.assertEqual(local_token("127.0.0.1", 1883), ("local", "home"))
        self.write(self.runtime / "u2sa", "runtime", 2000)
        self.assertEqual(local_token("127.0.0.1", 1883), ("local", "runtime"))
        self.write(self.home / ".u2sa" / "run", "later", 3000)
        self.assertEqual(local_token("127.0.0.1", 1883), ("local", "later"))

    def test_a_folder_that_others_may_write_to_is_not_used(self):
        self.write(self.runtime / "u2sa", "theirs", 2000)
        self.runtime.chmod(0o777)
        self.assertNotIn(self.runtime / "u2sa", token_folders())
        self.assertEqual(local_token("127.0.0.1", 1883), (None, None))

    def test_a_named_folder_replaces_the_usual_ones(self):
        self.write(self.home / ".u2sa" / "run", "home", 1000)
        named = self.home / "named"
        named.mkdir(mode=0o700)
        with mock.patch.dict(os.environ, {"U2SA_ACCOUNT_FOLDER": str(named)}):
            self.assertEqual(local_token("127.0.0.1", 1883), (None, None))
            self.write(named, "named", 500)
            self.assertEqual(local_token("127.0.0.1", 1883), ("local", "named"))
        with mock.patch.dict(os.environ, {"U2SA_ACCOUNT_FOLDER": "named"}):
            with self.assertRaisesRegex(ValueError, '"named" is not an absolute path'):
                token_folders()

    def test_a_refused_client_takes_the_token_of_the_broker_that_runs_now(self):
        self.write(self.home / ".u2sa" / "run", "first", 1000)
        one = Link(Broker(), "cessna", "Motor", lambda *_: None, lambda _: None)
        self.write(self.home / ".u2sa" / "run", "second", 2000)
        logins = []
        client = types.SimpleNamespace(username_pw_set=lambda *login: logins.append(login))
        one._connected(client, None, None, 4)
        self.assertEqual(logins, [("local", "second")])


if __name__ == "__main__":
    unittest.main()
