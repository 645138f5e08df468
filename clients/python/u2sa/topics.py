"""Topics and channels (docs/wire-protocol.md, Topics)."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Sequence, Tuple

from . import tables
from .message import Message
from .schema import Malformed

_SYSTEM_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,63}")
_CHANNEL = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


_ESCAPED = re.compile("[/+#% .*>\x00-\x1f\x7f-\x9f]")
_ESCAPED_BEFORE_FORMAT_3 = re.compile("[/+#%\x00-\x1f\x7f-\x9f]")


@dataclass(frozen=True)
class Topic:
    """Where a message stands on the broker.

    :param source: which of several sources on a retained channel the message is of; empty where they share a topic
    """

    system_id: str
    channel: str
    chain: Tuple[str, ...]
    source: str = ""

    @staticmethod
    def of(system_id: str, channel: str, message: Message) -> "Topic":
        """The topic of a message on a channel."""
        field = _channel(channel)[2]
        return Topic(system_id, channel, message.chain, message[field] if field and field in message else "")

    @staticmethod
    def parse(topic: str) -> "Topic":
        """:raises Malformed: if it is not of the form u2sa/<systemId>/<channel>/<TypeChain…>, =source perhaps behind it"""
        levels = topic.split("/")
        source = ""
        if len(levels) > 4 and levels[-1].startswith("="):
            source = _decoded(levels.pop()[1:])
        if len(levels) < 4 or levels[0] != "u2sa" or "" in levels or levels[-1].startswith("="):
            raise Malformed(f'topic "{topic}": expected u2sa/<systemId>/<channel>/<TypeChain…>')
        return Topic(check_system_id(levels[1]), levels[2], tuple(levels[3:]), source)

    def __str__(self) -> str:
        source = ("=" + encoded(self.source),) if self.source else ()
        return "/".join(("u2sa", self.system_id, self.channel, *self.chain, *source))


def encoded(name: str, escaped: "re.Pattern[str]" = _ESCAPED) -> str:
    """A name as one level: what MQTT or a broker gives a meaning or forbids as % and four hexadecimal digits."""
    return escaped.sub(lambda found: f"%{ord(found.group()):04X}", name)


def _decoded(level: str) -> str:
    source = re.sub("%([0-9A-F]{4})", lambda found: chr(int(found.group(1), 16)), level)
    if not level or level not in (encoded(source), encoded(source, _ESCAPED_BEFORE_FORMAT_3)):
        raise Malformed(f'source "{level}": expected a name, written as "{encoded(source)}"')
    return source


def check_system_id(system_id: str) -> str:
    """:raises Malformed: if it is no system ID"""
    if not _SYSTEM_ID.fullmatch(system_id):
        raise Malformed(f'system ID "{system_id}": expected 1 to 64 letters, digits, "_", "." or "-"')
    return system_id


def check_channel(channel: str) -> str:
    """:raises ValueError: if it is no name of a channel"""
    if not _CHANNEL.fullmatch(channel):
        raise ValueError(f'channel "{channel}": expected lower-case words joined by hyphens')
    return channel


def topic_filter(system_id: str, channel: str, chain: Sequence[str] = ()) -> str:
    """What brings a channel's messages of a class, subclasses included; of all classes without a chain."""
    return "/".join(("u2sa", system_id, channel, *chain, "#"))


def delivery(channel: str) -> Tuple[int, bool]:
    """QoS and retained flag of what is published on a channel; of one that is not standard: 1 and not retained."""
    return _channel(channel)[:2]


def _channel(name: str) -> Tuple[int, bool, str]:
    return tables.CHANNELS.get(name, (1, False, ""))
