"""What every service answers (thesis 3.2.2.1): discovery, functionality, stop and configuration."""
from __future__ import annotations

from collections import OrderedDict
from typing import TYPE_CHECKING, List, Sequence

from .codec import identity
from .configuration import Assignment, BadConfiguration
from .message import Message

if TYPE_CHECKING:
    from .service import Service

_REMEMBERED = 64
_REQUESTS_TO_ALL = ("FunctionalityRequest", "ConfigurationRequest")
_REQUESTS_TO_ONE = ("ConfigurationChange", "ConfigurationTransaction", "ConfigurationUndo")
_REQUESTS_ON = {
    "discovery": ("DiscoveryRequest",),
    "functionality": ("FunctionalityRequest",),
    "configuration": ("ConfigurationRequest", *_REQUESTS_TO_ONE),
}


class Contract:
    """Answers for one service, on its thread."""

    #: Where requests come in.
    CHANNELS = ("discovery", "functionality", "stop", "configuration")

    def __init__(self, service: "Service") -> None:
        self._service = service
        # A request that comes twice is obeyed once; another one under the same ID, or the same given again later, is no repeat.
        self._answered: "OrderedDict[bytes, Message]" = OrderedDict()  # by identity of the request

    def is_order_to_stop(self, message: Message) -> bool:
        return message.is_a("StopCommand") and (
            message.get("stopAll") is True or message.get("serviceName") == self._service.name)

    def concerns(self, channel: str, message: Message) -> bool:
        """Whether the message is a request that `answer` would answer, on the channel that carries it."""
        if not any(message.is_a(kind) for kind in _REQUESTS_ON.get(channel, ())):
            return False
        if any(message.is_a(kind) for kind in _REQUESTS_TO_ALL):
            return message["serviceName"] in ("", self._service.name)
        if any(message.is_a(kind) for kind in _REQUESTS_TO_ONE):
            return bool(message["serviceName"] == self._service.name)
        return message.is_a("DiscoveryRequest")

    def answer(self, channel: str, message: Message) -> None:
        if not self.concerns(channel, message):
            return
        if message.is_a("DiscoveryRequest"):
            self._discovery()
        elif message.is_a("FunctionalityRequest"):
            self._functionality()
        elif message.is_a("ConfigurationRequest"):
            self._configuration()
        else:
            self._once(message)

    def _discovery(self) -> None:
        service = self._service
        service.send("discovery", Message(
            "DiscoveryResponse", serviceName=service.name, serviceType=service.role, status=service.status,
            host=service.host, uptime=service.uptime_s, version=service.version, instance=service.link.instance,
            className=f"{type(service).__module__}.{type(service).__qualname__}"))

    def _functionality(self) -> None:
        service = self._service
        service.send("functionality", Message(
            "FunctionalityResponse", serviceName=service.name, publishes=self._described(service.publishers),
            subscribes=self._described(service.subscribers)))

    def _described(self, channels: "dict[str, str]") -> List[str]:
        return [f"{channel}/{'/'.join(self._service.chain_of(name))}" for channel, name in channels.items()]

    def _configuration(self) -> None:
        service = self._service
        service.send("configuration", Message(
            "ConfigurationResponse", serviceName=service.name, variables=service.configuration.describe(),
            revision=service.configuration.revision))

    def _once(self, message: Message) -> None:
        known_by = identity(message)
        before = None if known_by is None else self._answered.get(known_by)
        if before is not None:
            self._service.send("configuration", before)
            return
        done: List[str] = []
        result = self._change(message, done) if message.is_a("ConfigurationChange") else self._changes(message, done)
        if known_by is not None:
            self._answered[known_by] = result
        while len(self._answered) > _REMEMBERED:
            self._answered.popitem(last=False)
        self._service.send("configuration", result)
        if done:
            self._service.configuration_changed(done)

    def _change(self, message: Message, done: List[str]) -> Message:
        service, name = self._service, message["variableName"]
        result = Message("ConfigurationChangeResult", serviceName=service.name, variableName=name)
        try:
            self._require_in_time(message)
            service.configuration.change({name: message["value"]}, "", veto=service.configuration_refusal)
            result["accepted"] = True
            result["value"] = service.configuration.text(name)
            done.append(name)
        except BadConfiguration as e:
            result["value"] = message["value"]
            result["reason"] = str(e)
        return result

    def _require_in_time(self, order: Message) -> None:
        late = self._service.lateness(order)
        if late:
            raise BadConfiguration(late)

    def _changes(self, message: Message, names: List[str]) -> Message:
        result = Message("ConfigurationTransactionResult", requestId=message["requestId"], serviceName=self._service.name,
                         author=message.get("author"))
        try:
            self._require_in_time(message)
            done = self._undo(message) if message.is_a("ConfigurationUndo") else self._transact(message)
            result["accepted"] = True
            result["assignments"] = [
                Message("ConfigurationAssignment", variableName=name, value=now, previous=before)
                for name, before, now in done]
            names.extend(name for name, _before, _now in done)
        except BadConfiguration as e:
            result["reason"] = str(e)
            result["assignments"] = self._told_back(message)
        result["revision"] = self._service.configuration.revision
        return result

    def _told_back(self, message: Message) -> Sequence[Message]:
        """What was wanted and refused. More assignments than there are variables cannot be meant: the answer would be larger
        than a message may be, and is kept."""
        wanted: Sequence[Message] = message.get("assignments") if message.is_a("ConfigurationTransaction") else ()
        return wanted[:len(self._service.configuration.describe())]

    def _undo(self, message: Message) -> List[Assignment]:
        return self._service.configuration.undo(message.get("author"))

    def _transact(self, message: Message) -> List[Assignment]:
        wanted = {}
        for assignment in message.get("assignments"):
            name = assignment["variableName"]
            if name in wanted:
                raise BadConfiguration(f'variable "{name}" is named twice')
            wanted[name] = assignment["value"]
        return self._service.configuration.change(wanted, message.get("author"), message.get("revision"),
                                                  self._service.configuration_refusal)
