"""Texts with bounds of their own: names and identifiers are refused beyond them, notes are shortened (docs/wire-protocol.md)."""
from __future__ import annotations

from typing import List, Sequence

from .schema import Malformed

NOTES = 100
_CUT = "…"
_HALF_PAIR = "\ufffd"


def units(text: str) -> int:
    """How many UTF-16 code units it has: that is what the bounds count."""
    return len(text) + sum(char > "\uffff" for char in text)


def refused_beyond(longest: int, text: str, where: str) -> str:
    """A name or an identifier, whose part could be another one's. :raises Malformed: if it is longer"""
    if units(text) > longest:
        raise Malformed(f"{where}: expected at most {longest} characters, not {units(text)}")
    return text


def shortened(longest: int, note: str) -> str:
    """Text for people, of at most that length and of Unicode characters only, whatever it was composed of."""
    if len(note) <= longest and note.isascii():
        return note
    kept: List[str] = []
    room = longest if units(note) <= longest else longest - len(_CUT)
    for char in note:
        if room == 0:
            break
        wide = char > "\uffff"
        is_half = "\ud800" <= char <= "\udfff" or (wide and room == 1)
        kept.append(_HALF_PAIR if is_half else char)
        room -= 2 if wide and room > 1 else 1
    return "".join(kept) + (_CUT if units(note) > longest else "")


def shortened_list(longest: int, notes: Sequence[str]) -> "tuple[str, ...]":
    """At most 100 notes, the last of which says how many are missing."""
    if len(notes) > NOTES:
        notes = [*notes[:NOTES - 1], f"and {len(notes) - NOTES + 1} more"]
    return tuple(shortened(longest, note) for note in notes)
