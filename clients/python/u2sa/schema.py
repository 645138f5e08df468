"""The messages' classes and fields, in the order of the wire."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import tables

#: The key that opens a message within a list: its type chain.
TYPE_KEY = "type"


class Malformed(ValueError):
    """Bytes, a topic or a value that is not what docs/wire-protocol.md says; names field, value and what was expected."""


_UNKNOWN = "#"  # before the digits of a label that a reader did not know
_WRITTEN = {f"{_UNKNOWN}{label}": name for label, name in enumerate(tables.LABELS)}


def name_of(key: Union[int, str]) -> str:
    """The name of the field that a map's key stands for: the key itself, or what its label says."""
    text = f"{_UNKNOWN}{key}" if isinstance(key, int) else key
    return _WRITTEN.get(text, text)


@dataclass(frozen=True)
class Field:
    """One field of a message: name and kind as in the tables of docs/wire-protocol.md."""

    name: str
    kind: str
    presence: str  # optional, always or required
    default: Any
    least: Optional[float]
    most: Optional[float]
    choices: Tuple[str, ...]
    since: int
    longest: Optional[int] = None  # UTF-16 code units of a text, or of each in a list
    shortens: bool = False  # longer texts are shortened, not refused

    @property
    def required(self) -> bool:
        return self.presence == "required"


@dataclass(frozen=True)
class MessageType:
    """One class of messages."""

    chain: Tuple[str, ...]
    abstract: bool
    fields: Tuple[Field, ...]

    @property
    def name(self) -> str:
        return self.chain[-1]

    def field(self, name: str) -> Optional[Field]:
        return next((field for field in self.fields if field.name == name), None)


class Schema:
    """The classes that a reader knows. Immutable: `with_type` makes another one."""

    def __init__(self, types: Mapping[str, MessageType]) -> None:
        self._types: Dict[str, MessageType] = dict(types)

    @staticmethod
    def standard() -> "Schema":
        """The classes of docs/wire-protocol.md."""
        rows: List[Tuple[Any, ...]] = list(tables.MESSAGES)
        return Schema({chain[-1]: MessageType(chain, abstract, tuple(Field(*field) for field in fields))
                       for chain, abstract, fields in rows})

    def with_type(self, chain: Sequence[str], own_fields: Sequence[Field]) -> "Schema":
        """These and one more class, whose fields follow those of its nearest known ancestor."""
        parent = self.nearest(chain[:-1]) if len(chain) > 1 else None
        inherited = parent.fields if parent else _root_fields()
        return Schema({**self._types, chain[-1]: MessageType(tuple(chain), False, inherited + tuple(own_fields))})

    def type(self, name: str) -> MessageType:
        """The class of that name. :raises KeyError: if there is none"""
        try:
            return self._types[name]
        except KeyError:
            raise KeyError(f'there is no message "{name}"') from None

    def nearest(self, chain: Sequence[str]) -> Optional[MessageType]:
        """The nearest ancestor that is known, the class itself included (thesis 8.2.5); None if there is none.

        :raises Malformed: if the chain claims another ancestry for it than it has
        """
        for end in range(len(chain), 0, -1):
            known = self._types.get(chain[end - 1])
            if known is not None:
                if known.chain != tuple(chain[:end]):
                    raise Malformed(f"expected {'/'.join(known.chain)}, not {'/'.join(chain[:end])}")
                return known
        return None

    def names(self) -> List[str]:
        return list(self._types)


def _root_fields() -> Tuple[Field, ...]:
    return (Field("systemId", "text", "optional", None, None, None, (), 1),
            Field("timestamp", "int", "optional", None, None, None, (), 1))


#: The classes of docs/wire-protocol.md.
STANDARD = Schema.standard()
