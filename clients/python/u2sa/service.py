"""A service: it knows no other service and talks in messages (thesis 3.2.2.1)."""
from __future__ import annotations

import logging
import math
import pathlib
import platform
import signal
import threading
import time
from typing import Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import tables
from .clock import SystemTime
from .codec import decode
from .configuration import Configuration, Value, Variable
from .contract import Contract
from .emergency import EmergencyLatch
from .gaps import Gaps
from .health import Health
from .inbox import Inbox
from .link import Broker, Link
from .message import Message
from .occurrences import Occurrences
from .schema import STANDARD, Malformed, Schema
from .topics import Topic, check_channel, check_system_id, delivery, topic_filter

#: What every service has beside its own variables.
COMMON_VARIABLES = (
    Variable("HEALTH INTERVAL", 0.25, "s", 0.01, 3600.0, description="Time between two health reports."),
    Variable("INBOX CAPACITY", 1024, "", 1, 1_000_000,
             description="Messages that wait for the service before further ones are dropped and counted."),
    Variable("MAX ERRORS IN A ROW", 10, "", 1, 1_000_000,
             description="Exceptions one after the other at which the service ends itself."),
    Variable("ORDER EXPIRY", 5.0, "s", 0.0, 86_400.0,
             description="Age at which an order to stop or to change variables no longer counts; 0: never."),
)
_SILENT_INTERVALS = 3
_TIME_WITHIN_S = 1.0  # answers to the question for the system's time
_LOGGED_CHARACTERS = 500  # of what came from outside


class Service:
    """Extend it, register in the constructor, write `callback` and, for something to do at a rate, `step`.

    >>> class Altimeter(Service):
    ...     role = "PROPRIOCEPTIVE_SENSOR"
    ...     rate_hz = 10.0
    ...     def __init__(self, **context):
    ...         super().__init__("Altimeter", **context)
    ...         self.register_publisher("sensed-state", "StateInformation")
    ...     def step(self, now_s):
    ...         self.publish("sensed-state", Message("StateInformation", sensorName=self.name, z=300.0))

    What begins with two underscores here is out of the way of what authors call their own things.
    Everything but `publish` belongs to the thread that calls `run`. Discovery, functionality, stop, configuration and
    health are answered for every service here.

    :param name: unique within the system
    :param system_id: the vehicle
    :param broker: the Communication Manager: a `Broker`, or its address, such as "localhost:1883"
    :param variables: the service's own
    :param file: its configuration; without one, changes last as long as the object
    """

    #: What the service is for: a ServiceRole of docs/wire-protocol.md.
    role = "OBSERVER"
    #: How often `step` is called [Hz]; 0: never.
    rate_hz = 0.0
    #: Told to those who discover the service.
    version = "unversioned"

    def __init__(self, name: str, system_id: str = "cessna", broker: Union[Broker, str] = Broker(),
                 variables: Sequence[Variable] = (), file: Optional[pathlib.Path] = None,
                 schema: Schema = STANDARD) -> None:
        self.name = name
        self.system_id = check_system_id(system_id)
        self.configuration = Configuration((*variables, *COMMON_VARIABLES), file, name)
        self.health = Health()
        #: The system's time, which timestamps are taken from.
        self.clock = SystemTime()
        #: The emergency stops that hold, for services that subscribe to emergency-stop; health reports tell them.
        self.emergency = EmergencyLatch(system_id, self.clock.micros)
        self.log = logging.getLogger(f"u2sa.{name}")
        self.__occurrences = Occurrences()
        self.status = "CREATED"
        self.publishers: Dict[str, str] = {}
        self.subscribers: Dict[str, str] = {}
        self.__schema = schema
        self.__created = time.monotonic()
        self.__inbox = Inbox(int(self.configuration.number("INBOX CAPACITY")))
        self.__stopping = threading.Event()
        self.__reported = time.monotonic()
        self.__told: Optional[float] = None  # when data were published last
        self.__thread = threading.current_thread()
        self.link = Link(Broker.at(broker) if isinstance(broker, str) else broker, system_id, name, self._arrived, self._trouble)
        self.__contract = Contract(self)
        self.__gaps = Gaps()  # on paho's thread only

    # What authors write.

    def begin(self) -> None:
        """Called first, on the service's thread."""

    def callback(self, channel: str, message: Message) -> None:
        """Handles one message of a channel that was subscribed to."""

    def step(self, now_s: float) -> None:
        """Called `rate_hz` times a second. :param now_s: seconds since 1970"""

    def configuration_changed(self, names: List[str]) -> None:
        """Takes note that variables were changed from outside."""

    def configuration_refusal(self, values: Mapping[str, Value]) -> Optional[str]:
        """Why the service will not have these values together; None if it will."""
        return None

    def release(self) -> None:
        """Closes what `begin` opened and leaves actuators neutral. Called once."""

    # What authors call.

    def register_publisher(self, channel: str, name: str) -> None:
        """Says that messages of that class and its subclasses will be published on a channel."""
        self.__schema.type(name)
        self.publishers[check_channel(channel)] = name

    def register_subscriber(self, channel: str, name: str) -> None:
        """Asks for a channel's messages of that class and its subclasses. Call it before `run`."""
        self.__schema.type(name)
        self.subscribers[check_channel(channel)] = name

    def publish(self, channel: str, message: Message) -> bool:
        """Publishes on a registered channel, from any thread. Missing system ID and time are filled in.

        :returns: False, with the reason in the log, if the message was not taken
        """
        if not message.is_a(self.publishers.get(channel, "")):
            self.health.count("refused")
            self.log.error("not registered as a publisher of %s on %s: not published", message.name, channel)
            return False
        return self.send(channel, message)

    def send(self, channel: str, message: Message) -> bool:
        """`publish` without registration, for answers of the contract."""
        if "systemId" not in message:
            message["systemId"] = self.system_id
        if "timestamp" not in message:
            message["timestamp"] = self.clock.micros()
        taken = self.link.publish(channel, message)
        if not taken:
            self.health.count("refused")
        elif channel != "health" and channel not in Contract.CHANNELS:  # what the contract makes it say are no data
            self.health.count("published")
            self.__told = time.monotonic()
        return taken

    def stop(self) -> None:
        """Asks the service to end, from any thread; `run` returns soon after."""
        self.__stopping.set()

    def chain_of(self, name: str) -> Sequence[str]:
        """The type chain of a class of messages."""
        return self.__schema.type(name).chain

    @property
    def uptime_s(self) -> float:
        return time.monotonic() - self.__created

    @property
    def host(self) -> str:
        return platform.node()

    # The service's life.

    def run(self, signals: bool = True, patience_s: float = 30.0) -> int:
        """Connects and serves until stopped; returns the process's exit code.

        :param signals: end in order on SIGTERM and SIGINT; only the main thread can ask for that
        :param patience_s: for a broker that does not listen yet, because its vehicle is just starting
        :raises CannotConnect: if the broker is not there within that time, or refuses
        """
        self.__thread = threading.current_thread()
        self.link.open(patience_s=patience_s)
        if signals:
            for number in (signal.SIGTERM, signal.SIGINT):
                signal.signal(number, lambda _number, _frame: self.stop())
        self._follow_time()
        for channel, chain in self._filters():
            self.link.subscribe(topic_filter(self.system_id, channel, chain))
        self.status = "RUNNING"
        watch = threading.Thread(target=self._watch, name=f"{self.name} watch", daemon=True)
        watch.start()
        try:
            self._guarded(self.begin)
            self._loop()
        finally:
            failed = self.status == "FAILED"
            self.status = "FAILED" if failed else "STOPPING"
            self._guarded(self.release)
            self.status = "FAILED" if failed else "STOPPED"
            self._report()
            self.__stopping.set()
            self.link.close()
        return 1 if failed else 0

    def _follow_time(self) -> None:
        """Others judge data and orders by their age: takes the time of the services that run, before anything is sent with a time."""
        self.link.subscribe(topic_filter(self.system_id, "discovery", ()))
        self.clock.asked()
        self.send("discovery", Message("DiscoveryRequest"))
        until = time.monotonic() + _TIME_WITHIN_S
        while not self.clock.is_settled() and time.monotonic() < until and not self.__stopping.wait(0.01):
            pass
        ahead = self.clock.follow()
        if ahead:
            self.log.warning("this computer's clock is %.3f s %s the system's time: follows it",
                             abs(ahead), "behind" if ahead > 0 else "ahead of")

    def _filters(self) -> List[Tuple[str, Sequence[str]]]:
        own: List[Tuple[str, Sequence[str]]] = [(channel, self.__schema.type(name).chain) for channel, name in self.subscribers.items()]
        return own + [(channel, ()) for channel in Contract.CHANNELS if channel not in self.subscribers]

    def _loop(self) -> None:
        period = 1.0 / self.rate_hz if self.rate_hz > 0.0 else None
        next_step = time.monotonic()
        while not self.__stopping.is_set() and self.status == "RUNNING":
            now = time.monotonic()
            due = self.__reported + self.configuration.number("HEALTH INTERVAL")
            if now >= due:
                self._report()
                continue
            if period is not None and now >= next_step:
                missed = int((now - next_step) / period)
                if missed:
                    self.health.count("overruns", missed)
                next_step += (missed + 1) * period
                self._guarded(lambda: self.step(self.clock.seconds()))
                continue
            self._take(max(0.0, min(due, next_step if period is not None else due) - now))

    def _take(self, within_s: float) -> None:
        """Handles the next message, if one comes in time. A stop is noticed at the next health report at the latest."""
        item = self.__inbox.take(max(within_s, 0.0005))
        if item is not None:
            channel, message = item
            self._guarded(lambda: self._handle(channel, message))

    def _handle(self, channel: str, message: Message) -> None:
        if channel in Contract.CHANNELS:
            self._surviving("answering a request", lambda: self.__contract.answer(channel, message))
        if message.is_a(self.subscribers.get(channel, "")):
            if channel == "emergency-stop":
                self._latch(message)
            self.callback(channel, message)

    def _latch(self, message: Message) -> None:
        before = self.emergency.stops
        self.emergency.take(message)
        if self.emergency.stops != before:
            self.__reported = -math.inf  # tells at once: whoever stops the vehicle waits for it
        if self.role == "ACTUATOR" and not message.get("active"):
            self._repeat_what_holds(message)

    def _repeat_what_holds(self, clear: Message) -> None:
        """A clear is retained: who comes late must not take it for the end of a stop that it does not cover."""
        held = self.emergency.newest
        if held is not None:
            self.log.warning("the clear by \"%s\" leaves the stop by \"%s\": still stopped",
                             clear.get("operator", ""), held.get("operator", ""))
            self.send("emergency-stop", held)
            self.link.forget("emergency-stop", held)  # a broker without memory gets it from who keeps the vehicle safe

    def _surviving(self, what: str, code: Callable[[], None]) -> None:
        """Runs the framework's own code, on any thread. What others send must not end the service: an exception is logged
        and counted, but not among those in a row, which are for the author's code."""
        try:
            code()
        except Exception as e:
            error, count = self.health.failed(e), self.__occurrences.to_log(what)
            if count is not None:
                self.log.error("%s failed (%d times so far): %s", what, count, error, exc_info=e)

    def _guarded(self, code: Callable[[], None]) -> None:
        failure = self.health.run(code)
        if failure is None:
            return
        where = failure if self.__occurrences.to_log("exceptions") is not None else None
        self.log.error("%s (exception %d in a row)", self.health.last_error, self.health.in_a_row, exc_info=where)
        if self.health.in_a_row >= self.configuration.number("MAX ERRORS IN A ROW"):
            self.log.error("ends itself after %d exceptions in a row", self.health.in_a_row)
            self.status = "FAILED"

    def _arrived(self, topic: str, payload: bytes, retained: bool = False) -> None:
        """On paho's thread: reads and queues, and obeys a stop at once.

        :param retained: whether it was published before the subscription that brings it
        """
        self._surviving("receiving a message", lambda: self._receive(topic, payload, retained))

    def _receive(self, topic: str, payload: bytes, retained: bool) -> None:
        try:
            where = Topic.parse(topic)
            if retained and where.channel in tables.CHANNELS and not delivery(where.channel)[1]:
                raise Malformed(f"it was retained, and {where.channel} retains nothing")
            message = decode(where.chain, payload, self.__schema)
        except Malformed as e:
            self.health.count("refused")
            count = self.__occurrences.to_log("unreadable")
            if count is not None:
                self.log.warning("a message on %.*r cannot be read (%d so far): %.*s", _LOGGED_CHARACTERS, topic, count,
                                 _LOGGED_CHARACTERS, e)
            return
        missing = self.__gaps.missing_before(topic, message.origin)
        if missing is None and self._is_state(where.channel):
            return
        if missing:
            self.health.count("missed", missing)
        if where.channel == "discovery" and message.is_a("DiscoveryResponse"):
            self.clock.hear(message.get("timestamp"))
        if where.channel == "stop" and self.__contract.is_order_to_stop(message):
            late = self.lateness(message)
            if late:
                self.log.warning("not stopped, because %s", late)
                return
            self.stop()
            self.__inbox.wake()
            return
        if not self.__contract.concerns(where.channel, message) and not message.is_a(self.subscribers.get(where.channel, "")):
            return
        outcome = self.__inbox.put(where.channel, message)
        if outcome:
            self.health.count(outcome)

    def lateness(self, order: Message) -> str:
        """Why not to obey an order: it is older than ORDER EXPIRY; empty if it is in time or carries no time.

        A broker may have kept it while a link was down.
        """
        expiry = self.configuration.number("ORDER EXPIRY")
        given = order.get("timestamp")
        age = 0.0 if given is None else self.clock.seconds() - given / 1e6
        if expiry == 0.0 or age <= expiry:
            return ""
        return (f"the order arrived {age:.1f} s after it was given; expected at most ORDER EXPIRY, {expiry:g} s: "
                "give it again (if it was given just now, the clocks differ)")

    @staticmethod
    def _is_state(channel: str) -> bool:
        """Whether an old message must not follow a new one, as some brokers deliver them. A stop always counts."""
        return channel in tables.CHANNELS and delivery(channel)[1] and channel != "emergency-stop"

    def _report(self) -> None:
        self.__reported = time.monotonic()
        self._surviving("the health report", lambda: self.__send_report({}))

    def __send_report(self, more: Mapping[str, object]) -> None:
        report = self._described(self.health.report(self.name, self.status, self.__inbox.depth()))
        for key, value in more.items():
            report[key] = value
        self.send("health", report)

    def _described(self, report: Message) -> Message:
        report["instance"] = self.link.instance
        report["interval"] = self.configuration.number("HEALTH INTERVAL")
        if "emergency-stop" in self.subscribers:
            report["emergencyStops"] = self.emergency.stops
        report["refusedSubscriptions"] = ", ".join(self.link.refused_channels())
        if self.__told is not None:
            report["dataAge"] = time.monotonic() - self.__told
        return report

    def _watch(self) -> None:
        """Reports on behalf of a service whose own thread is silent: whether it lives, and what it hangs in."""
        interval = self.configuration.number("HEALTH INTERVAL")
        while not self.__stopping.wait(interval):
            interval = self.configuration.number("HEALTH INTERVAL")
            if time.monotonic() - self.__reported > _SILENT_INTERVALS * interval:
                stuck = {"threadAlive": self.__thread.is_alive(), "callbackRunning": self.health.running_s()}
                self._surviving("the health report", lambda: self.__send_report(stuck))

    def _trouble(self, what: str) -> None:
        self.log.warning("%s", what)
