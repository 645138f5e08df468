"""The audit log beside a configuration file: who changed what, and when; one line of JSON a change, as Java's services
write it (docs/remote-configuration.md), so that revision and undo go on whoever serves the file next."""
from __future__ import annotations

import json
import os
import pathlib
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Any, Dict, List, Optional, Tuple

#: What a change did to one variable: name, value before, value now, as texts.
Assignment = Tuple[str, str, str]


@dataclass(frozen=True)
class Change:
    """A change that was made. :param undoes: revision of the change that it took back"""

    revision: int
    values: Tuple[Assignment, ...]
    undoes: Optional[int] = None


class AuditLog:
    """The log of one file, read once and then written.

    :param file: the configuration file; None: nothing is written
    :param service: through which service changes come
    """

    def __init__(self, file: Optional[pathlib.Path], service: str) -> None:
        self._path = None if file is None else pathlib.Path(f"{file}.audit.jsonl")
        self._service = service
        self._standing: List[Change] = []
        self.revision = 0
        if self._path is not None and self._path.exists():
            for line in self._path.read_text(encoding="utf-8", errors="replace").split("\n"):
                self._remember(line)

    @property
    def undoable(self) -> Optional[Change]:
        """The newest change that was not taken back; None if there is none."""
        undone = {change.undoes for change in self._standing}
        return next((change for change in reversed(self._standing)
                     if change.undoes is None and change.revision not in undone), None)

    def accepted(self, author: str, values: List[Assignment], undoes: Optional[int]) -> None:
        """Says that a change is about to be written. :raises OSError: if that cannot be said"""
        change = Change(self.revision + 1, tuple(values), undoes)
        self._write(change.revision, author, "ACCEPTED", "", values, undoes)
        self._standing.append(change)
        self.revision = change.revision

    def failed(self, author: str, reason: str) -> None:
        """Says that the change accepted last did not come to be."""
        change = self._standing.pop()
        self.revision = change.revision - 1
        try:
            self._write(change.revision, author, "FAILED", reason, list(change.values), change.undoes)
        except OSError:
            return  # the same disk that would not take the change; who asked is told

    def refused(self, author: str, reason: str, wanted: Dict[str, str]) -> None:
        """Says that nothing was changed, and why. A log that cannot be written does not stand in the way of the answer."""
        try:
            self._write(self.revision, author, "REFUSED", reason, [(name, "", new) for name, new in wanted.items()], None)
        except OSError:
            return

    def _write(self, revision: int, author: str, outcome: str, reason: str, values: List[Assignment],
               undoes: Optional[int]) -> None:
        if self._path is None:
            return
        entry: Dict[str, Any] = {
            "revision": revision, "time": datetime.now(timezone.utc).isoformat().replace("+00:00", "Z"),
            "service": self._service, "author": author, "outcome": outcome}
        if reason:
            entry["reason"] = reason
        if undoes is not None:
            entry["undoes"] = undoes
        entry["changes"] = [
            {"variable": name, "new": now} if outcome == "REFUSED" else
            {"variable": name, "old": before, "new": now, "oldText": before, "newText": now}
            for name, before, now in values]
        torn = self._path.exists() and not self._path.read_bytes().endswith(b"\n") and self._path.stat().st_size > 0
        with open(self._path, "a", encoding="utf-8", errors="backslashreplace") as log:
            log.write(("\n" if torn else "") + json.dumps(entry, ensure_ascii=False, separators=(",", ":")) + "\n")
            log.flush()
            os.fsync(log.fileno())

    def _remember(self, line: str) -> None:
        """Goes on with the last run's; a line that a power cut left half is passed over."""
        try:
            entry = json.loads(line)
            revision, outcome, undoes = int(entry["revision"]), entry["outcome"], entry.get("undoes")
            if outcome == "ACCEPTED":
                values = tuple((str(each["variable"]), str(each.get("old", "")), str(each["new"])) for each in entry["changes"])
                self._standing.append(Change(revision, values, None if undoes is None else int(undoes)))
        except (ValueError, KeyError, TypeError):
            return
        if outcome == "FAILED":
            self._standing = [change for change in self._standing if change.revision != revision]
            revision -= 1
        self.revision = revision
