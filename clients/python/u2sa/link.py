"""The one place that knows paho-mqtt, 1.6 and 2.x alike: a connection that comes back by itself."""
from __future__ import annotations

import contextlib
import os
import pathlib
import re
import ssl
import stat
import threading
import time
import uuid
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Set, Tuple

import paho.mqtt.client as mqtt

from .codec import encode
from .message import Message
from .occurrences import Occurrences
from .retained import Retained
from .topics import Topic, delivery, encoded

try:
    import pwd
except ImportError:  # no POSIX accounts
    pwd = None  # type: ignore[assignment]

_KEEP_ALIVE_S = 5
_BACK_OFF_S = (1, 30)
_AGAIN_AFTER_S = 0.25
_IN_FLIGHT = 4096


@dataclass(frozen=True)
class Broker:
    """Where the Communication Manager is, and who we are to it.

    :param ca_file: certificate of the authority that signed the broker's; given, the connection is TLS
    :param cert_file, key_file: the client's own, where the broker asks for one
    """

    host: str = "localhost"
    port: int = 1883
    user: Optional[str] = None
    password: Optional[str] = None
    ca_file: Optional[str] = None
    cert_file: Optional[str] = None
    key_file: Optional[str] = None

    @staticmethod
    def at(address: str) -> "Broker":
        """The broker at HOST or HOST:PORT. :raises ValueError: if the address is not of that form"""
        match = re.fullmatch(r"(?:\[([0-9a-fA-F:]+)\]|([^:\s]+))(?::([0-9]{1,5}))?", address)
        port = int(match.group(3) or 1883) if match else 0
        if match is None or not 1 <= port <= 65535:
            raise ValueError(f'broker "{address}": expected HOST or HOST:PORT, such as localhost:1883')
        return Broker(match.group(1) or match.group(2), port)


def loopback(host: str) -> Optional[str]:
    """The loopback address that is meant; None for any other host, and for names of one."""
    if host.lower() == "localhost":
        return "127.0.0.1"
    if host in ("::1", "[::1]"):
        return "::1"
    return host if re.fullmatch(r"127(\.[0-9]{1,3}){3}", host) else None


def token_folders() -> List[pathlib.Path]:
    """Where the account's programs leave tokens for each other: every broker writes to all of them, as sessions of one account differ in the variable.

    U2SA_ACCOUNT_FOLDER, an absolute path, replaces them.
    """
    only = os.environ.get("U2SA_ACCOUNT_FOLDER", "")
    if only:
        if not os.path.isabs(only):
            raise ValueError(f'U2SA_ACCOUNT_FOLDER: "{only}" is not an absolute path')
        return [pathlib.Path(only)]
    runtime = os.environ.get("XDG_RUNTIME_DIR", "")
    homes = [pathlib.Path(os.path.expanduser("~"))]
    if pwd is not None:
        with contextlib.suppress(KeyError):  # an account without an entry
            homes.insert(0, pathlib.Path(pwd.getpwuid(os.getuid()).pw_dir))  # as Java has it, whatever HOME says
    folders = [pathlib.Path(runtime, "u2sa")] if runtime and _is_private(pathlib.Path(runtime)) else []
    return list(dict.fromkeys([*folders, *(home / ".u2sa" / "run" for home in homes)]))


def _is_private(path: pathlib.Path) -> bool:
    """Whether it is a folder of this account that nobody else may write to."""
    try:
        facts = path.lstat()
    except OSError:
        return False
    return stat.S_ISDIR(facts.st_mode) and (pwd is None or facts.st_uid == os.getuid() and not facts.st_mode & 0o022)


def local_token(address: str, port: int) -> Tuple[Optional[str], Optional[str]]:
    """As whom this account's programs come to a broker that the account started at this loopback address; nobody if there is none.

    Of several tokens the newest is the running broker's: the others were left by killed ones.
    """
    suffix = "" if address == "127.0.0.1" else "-" + re.sub("[^0-9A-Za-z.-]", "_", address)
    found: List[Tuple[float, str]] = []
    for folder in token_folders():
        file = folder / f"broker-{port}{suffix}.token"
        try:
            if not _is_private(folder) or not file.is_file() or file.stat().st_mode & 0o077:
                continue
            token = file.read_text(encoding="utf-8").strip()
            if token:
                found.append((file.stat().st_mtime, token))
        except (OSError, UnicodeDecodeError):
            continue  # the broker says what one without it may not do
    return ("local", max(found)[1]) if found else (None, None)


class CannotConnect(ConnectionError):
    """The broker cannot be reached, or refused; names the address."""


class Link:
    """One service's connection. All calls are safe from any thread.

    :param received: called with topic, payload and retained flag of each message, on paho's thread
    :param trouble: called with one line when the connection is lost, restored or refused
    """

    def __init__(self, broker: Broker, system_id: str, service: str,
                 received: Callable[[str, bytes, bool], None], trouble: Callable[[str], None]) -> None:
        self.instance = str(uuid.uuid4())
        self._broker = broker
        self._host = broker.host
        self._system_id = system_id
        self._received = received
        self._trouble = trouble
        self._occurrences = Occurrences()
        self._filters: Set[str] = set()
        self._asked: Dict[int, str] = {}  # filter by packet identifier, until the broker answers
        self._refused: Set[str] = set()  # filters that the broker did not grant
        self._numbers: Dict[str, int] = {}  # of the last message by topic
        self._retained = Retained()
        self._lock = threading.Lock()
        self._answered = threading.Event()
        self._refusal: Optional[str] = None
        self._closing = False
        # Not the instance, which is published: where any user may take any ID, a reader would throw the service out.
        self._client = self._made(f"{encoded(system_id)}/{encoded(service)}/{uuid.uuid4()}")
        will = Message("ConnectionLost", systemId=system_id, serviceName=service, status="FAILED",
                       lastError="connection lost", instance=self.instance)
        self._client.will_set(str(Topic(system_id, "health", will.chain)), encode(will), qos=1, retain=False)

    def _made(self, client_id: str) -> Any:
        versions = getattr(mqtt, "CallbackAPIVersion", None)
        first: Dict[str, Any] = {"callback_api_version": versions.VERSION2} if versions else {}
        client: Any = mqtt.Client(client_id=client_id, clean_session=True, protocol=mqtt.MQTTv311, **first)
        broker = self._broker
        if broker.user is not None:
            client.username_pw_set(broker.user, broker.password)
        self._prefer_token(client)
        if broker.ca_file is not None:
            client.tls_set(broker.ca_file, broker.cert_file, broker.key_file, tls_version=ssl.PROTOCOL_TLS_CLIENT)
        client.reconnect_delay_set(*_BACK_OFF_S)
        client.max_inflight_messages_set(_IN_FLIGHT)
        client.max_queued_messages_set(_IN_FLIGHT)
        client.on_connect = self._surviving("connecting", self._connected)
        client.on_disconnect = self._surviving("disconnecting", self._disconnected)
        client.on_message = self._surviving("receiving a message", self._message)
        client.on_subscribe = self._surviving("subscribing", self._subscribed)
        return client

    def _take_token(self, client: Any) -> None:
        """Has the next connection use the present token: a broker that was started again has another."""
        local = loopback(self._broker.host)
        if self._broker.user is None and self._broker.ca_file is None and local is not None and self._host == local:
            user, password = local_token(local, self._broker.port)
            if user is not None:
                client.username_pw_set(user, password)

    def _prefer_token(self, client: Any) -> None:
        """Goes where this account has a token, if the broker has left one, and nobody else was named."""
        broker = self._broker
        local = loopback(broker.host)
        if broker.user is None and broker.ca_file is None and local is not None:
            if local_token(local, broker.port)[0] is not None:
                self._host = local  # at another address of the same name any account of this host may listen
            self._take_token(client)

    def _connect(self) -> None:
        """Tries to connect once: a broker that has just started has left its token."""
        self._prefer_token(self._client)
        self._client.connect(self._host, self._broker.port, _KEEP_ALIVE_S)

    def _surviving(self, what: str, callback: Callable[..., None]) -> Callable[..., None]:
        """A callback that reports its exceptions: they would end paho's thread, and with it the connection."""
        def survivor(*details: Any) -> None:
            try:
                callback(*details)
            except Exception as e:
                count = self._occurrences.to_log(what)
                if count is not None:
                    self._trouble(f"{what} failed ({count} times so far): {type(e).__name__}: {e}")
        return survivor

    def open(self, within_s: float = 5.0, patience_s: float = 0.0) -> None:
        """Connects; later losses are repaired without a word to the caller.

        :param within_s: for the broker's answer
        :param patience_s: for a broker that does not listen yet
        :raises CannotConnect: if that fails
        """
        address = f"{self._broker.host}:{self._broker.port}"
        until = time.monotonic() + patience_s
        waits = False
        while True:
            try:
                self._connect()
                break
            except (OSError, ValueError) as e:
                if not isinstance(e, ConnectionRefusedError) or time.monotonic() >= until:
                    after = f" after {patience_s:g} s" if waits else ""
                    raise CannotConnect(f"no Communication Manager at {address}{after}: {e}") from None
                if not waits:
                    self._trouble(f"no Communication Manager at {address} yet; trying for {patience_s:g} s")
                waits = True
                time.sleep(min(_AGAIN_AFTER_S, max(0.0, until - time.monotonic())))
        self._client.loop_start()
        if not self._answered.wait(within_s) or self._refusal is not None:
            reason = self._refusal or f"no answer within {within_s} s"
            self.close()
            raise CannotConnect(f"the Communication Manager at {address} refused: {reason}")

    def subscribe(self, topic_filter: str) -> None:
        """Asks for the topics of a filter, now and after each reconnection."""
        with self._lock:
            self._filters.add(topic_filter)
            self._ask(self._client, topic_filter)

    def _ask(self, client: Any, topic_filter: str) -> None:
        """Called with the lock, so that the answer does not come before its question is known."""
        self._asked[client.subscribe(topic_filter, 1)[1]] = topic_filter

    def _subscribed(self, _client: Any, _data: Any, packet: int, codes: Any, *_rest: Any) -> None:
        with self._lock:
            topic_filter = self._asked.pop(packet, None)
            if topic_filter is None:
                return
            is_refused = any(getattr(code, "value", code) >= 0x80 for code in codes)
            is_news = is_refused and topic_filter not in self._refused
            (self._refused.add if is_refused else self._refused.discard)(topic_filter)
        if is_news:
            self._trouble(f"the broker refuses the subscription to {topic_filter}; it is asked again at the next connection")

    def refused_channels(self) -> List[str]:
        """Channels that the broker does not let us hear."""
        with self._lock:
            return sorted({topic_filter.split("/")[2] for topic_filter in self._refused})

    def publish(self, channel: str, message: Message) -> bool:
        """Hands a message over; False if it was not taken, such as while the connection is lost."""
        qos, retained = delivery(channel)
        topic = str(Topic.of(self._system_id, channel, message))
        with self._lock:  # numbers leave in their order
            self._numbers[topic] = self._numbers.get(topic, 0) + 1
            payload = encode(message, (self.instance, self._numbers[topic]))
            connected = self._client.is_connected()
            if retained:
                self._retained.publishing(topic, payload, connected)
            if not connected:
                return False  # it would be old when the connection is back
            return bool(self._client.publish(topic, payload, qos, retained).rc == mqtt.MQTT_ERR_SUCCESS)

    def forget(self, channel: str, message: Message) -> None:
        """A retained message is not ours to publish again."""
        self._retained.forget(str(Topic.of(self._system_id, channel, message)))

    def close(self, flush_s: float = 2.0) -> None:
        """Leaves in order, so that no will is sent. Safe to call twice."""
        self._closing = True
        try:
            self._client.disconnect()
            thread = getattr(self._client, "_thread", None)
            if thread is not None and thread is not threading.current_thread():
                thread.join(flush_s)
        finally:
            self._client.loop_stop()

    # Version 1 of paho's callbacks hands over a number, version 2 an object, and other arguments around it.
    def _connected(self, client: Any, _data: Any, _flags: Any, code: Any, *_rest: Any) -> None:
        failed = code.is_failure if hasattr(code, "is_failure") else code != 0
        again = self._answered.is_set()
        self._refusal = (str(code) if hasattr(code, "is_failure") else mqtt.connack_string(code)) if failed else None
        if failed:
            self._trouble(f"the broker refused: {self._refusal}")
            self._take_token(client)
        else:
            with self._lock:
                self._asked.clear()
                for topic_filter in sorted(self._filters):
                    self._ask(client, topic_filter)
            if again:
                self._retained.restore(client)
                self._trouble("connection restored")
        self._answered.set()

    def _message(self, _client: Any, _data: Any, packet: Any) -> None:
        topic = packet.topic
        self._retained.arrived(topic)
        self._received(topic, packet.payload, bool(packet.retain))

    def _disconnected(self, client: Any, _data: Any, *details: Any) -> None:
        self._retained.unconfirmed(self._discarded(client))
        if not self._closing:
            code = details[-2] if len(details) > 1 else details[0]
            self._trouble(f"connection lost: {code}")
            self._take_token(client)

    @staticmethod
    def _discarded(client: Any) -> List[str]:
        """Drops what was sent and not acknowledged, which paho would send again however old it is then.

        :returns: the topics of the retained messages among it
        """
        with client._out_message_mutex:
            topics = [message.topic for message in client._out_messages.values() if message.retain]
            client._out_messages.clear()
            client._inflight_messages = 0
        return topics
