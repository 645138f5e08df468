"""Topics and channels (docs/wire-protocol.md, Topics)."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Sequence, Tuple

from . import tables
from .schema import Malformed

_SYSTEM_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,63}")
_CHANNEL = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


@dataclass(frozen=True)
class Topic:
    """Where a message stands on the broker."""

    system_id: str
    channel: str
    chain: Tuple[str, ...]

    @staticmethod
    def parse(topic: str) -> "Topic":
        """:raises Malformed: if it is not of the form u2sa/<systemId>/<channel>/<TypeChain…>"""
        levels = topic.split("/")
        if len(levels) < 4 or levels[0] != "u2sa" or "" in levels:
            raise Malformed(f'topic "{topic}": expected u2sa/<systemId>/<channel>/<TypeChain…>')
        return Topic(check_system_id(levels[1]), levels[2], tuple(levels[3:]))

    def __str__(self) -> str:
        return "/".join(("u2sa", self.system_id, self.channel, *self.chain))


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
    return tables.CHANNELS.get(channel, (1, False))
