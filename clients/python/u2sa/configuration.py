"""A service's variables (thesis 3.2.1.1): declared, read from the XML file that Java's services have too, changed all
or none, written whole or not at all, and undone."""
from __future__ import annotations

import math
import os
import pathlib
import re
import tempfile
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from typing import Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from .audit import Assignment, AuditLog
from .message import Message

Value = Union[str, float, int, bool]
_DECIMAL = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
_MAX_CHARACTERS = 1_000_000
_WHOLE = re.compile(r"[+-]?[0-9]{1,20}")
_OUTSIDE = r"((?:\s|<!--.*?-->)*)"  # comments before and behind the root, which ElementTree does not keep
_BEFORE = re.compile(r"(?:<\?xml.*?\?>)?" + _OUTSIDE, re.DOTALL)
_BEHIND = re.compile(r"</configuration\s*>" + _OUTSIDE + r"\Z", re.DOTALL)
_NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_TYPES = {"string": str, "double": float, "int": int, "boolean": bool}


class BadConfiguration(ValueError):
    """A configuration that cannot be used, or a change that is refused: file, variable, value and what was expected."""


@dataclass(frozen=True)
class Variable:
    """One variable: its type is that of its default; limits are of numbers and included."""

    name: str
    default: Value
    unit: str = ""
    least: Optional[float] = None
    most: Optional[float] = None
    choices: Tuple[str, ...] = ()
    description: str = ""

    @property
    def type(self) -> str:
        """string, double, int or boolean."""
        return next(name for name, kind in _TYPES.items() if type(self.default) is kind)

    def parsed(self, text: str) -> Value:
        """The value that the text stands for, in this variable's unit. :raises BadConfiguration: if it may not have it"""
        value: Value = text
        unfit = _NOT_IN_XML.search(text)
        if unfit:
            raise BadConfiguration(f"the character U+{ord(unfit.group()):04X} cannot stand in an XML file")
        if self.type == "double":
            if not _DECIMAL.fullmatch(text.strip()) or not math.isfinite(float(text)):
                raise BadConfiguration(f'"{text}" is not a number')
            value = float(text)
        elif self.type == "int":
            if not _WHOLE.fullmatch(text.strip()) or not -(1 << 31) <= int(text) < 1 << 31:
                raise BadConfiguration(f'"{text}" is not a whole number of 32 bits')
            value = int(text)
        elif self.type == "boolean":
            if text.strip().lower() not in ("true", "false"):
                raise BadConfiguration(f'"{text}" is neither true nor false')
            value = text.strip().lower() == "true"
        if isinstance(value, (int, float)) and not isinstance(value, bool) and not self._within(value):
            low = "-∞" if self.least is None else self.least
            high = "∞" if self.most is None else self.most
            raise BadConfiguration(f"{text} is outside {low}…{high}" + (f" {self.unit}" if self.unit else ""))
        if self.choices and text not in self.choices:
            raise BadConfiguration(f'"{text}" is not one of {", ".join(self.choices)}')
        return value

    def _within(self, value: float) -> bool:
        return (self.least is None or value >= self.least) and (self.most is None or value <= self.most)

    def described(self, value: Value) -> Message:
        """As a configuration response tells it."""
        message = Message("ConfigurationVariable", name=self.name, variableType=self.type, value=as_text(value),
                          unit=self.unit, description=self.description)
        if self.least is not None:
            message["min"] = self.least
        if self.most is not None:
            message["max"] = self.most
        if self.choices:
            message["choices"] = self.choices
        return message


def as_text(value: Value) -> str:
    """A value as it stands in files and messages."""
    return str(value).lower() if isinstance(value, bool) else str(value)


class Configuration:
    """The variables of one service. Belongs to the service's thread.

    :param file: the XML file; without one, changes last as long as the object. What it does not state has its default.
    :param service: for the audit log
    :raises BadConfiguration: if the file is not such a file, or states what no variable may have
    """

    def __init__(self, variables: Sequence[Variable], file: Optional[pathlib.Path] = None,
                 service: str = "") -> None:
        self._variables: Dict[str, Variable] = {variable.name: variable for variable in variables}
        self._values: Dict[str, Value] = {variable.name: variable.default for variable in variables}
        self._file = file
        self._log = AuditLog(file, service)
        for name, (text, unit) in _stated(file).items() if file is not None else ():
            self._values[name] = self._parsed(name, text)
            own = self._variables[name].unit
            if unit != "" and unit != own:
                raise BadConfiguration(f'{file}, variable "{name}": {text} {unit}: units are not converted here; '
                                       + (f"expected {own}" if own else "expected no unit"))

    @property
    def revision(self) -> int:
        """Counts the changes, from 0."""
        return self._log.revision

    def __getitem__(self, name: str) -> Value:
        return self._values[name]

    def number(self, name: str) -> float:
        """The value of a number, in the variable's unit."""
        value = self._values[name]
        if isinstance(value, (str, bool)):
            raise TypeError(f'variable "{name}" is no number')
        return float(value)

    def text(self, name: str) -> str:
        return as_text(self._values[name])

    def describe(self) -> List[Message]:
        return [variable.described(self._values[name]) for name, variable in self._variables.items()]

    def change(self, wanted: Mapping[str, str], author: str, seen: Optional[int] = None,
               veto: Callable[[Mapping[str, Value]], Optional[str]] = lambda values: None) -> List[Assignment]:
        """Gives all these variables new values, or none of them.

        :param author: for the audit log
        :param seen: the revision that the author relies on; None: whatever it is
        :param veto: why the service will not have these values; None if it will
        :raises BadConfiguration: saying why nothing was changed
        """
        try:
            return self._change(wanted, author, seen, veto)
        except BadConfiguration as e:
            self._log.refused(author, str(e), dict(wanted))
            raise

    def undo(self, author: str) -> List[Assignment]:
        """Takes the last change that stands back. :raises BadConfiguration: if there is none, or it cannot be written"""
        last = self._log.undoable
        if last is None:
            raise BadConfiguration("there is no change to take back")
        return self._change({name: before for name, before, _now in last.values}, author, None, lambda values: None,
                            last.revision)

    def _change(self, wanted: Mapping[str, str], author: str, seen: Optional[int],
                veto: Callable[[Mapping[str, Value]], Optional[str]], undoes: Optional[int] = None) -> List[Assignment]:
        if seen is not None and seen != self.revision:
            raise BadConfiguration(f"revision {seen} was expected, but it is {self.revision}: somebody else changed "
                                   "the configuration meanwhile")
        if not wanted:
            raise BadConfiguration("names no variable")
        parsed = {name: self._parsed(name, text) for name, text in wanted.items()}
        refusal = veto(parsed)
        if refusal is not None:
            raise BadConfiguration(refusal)
        done = [(name, as_text(self._values[name]), as_text(value)) for name, value in parsed.items()]
        try:
            self._log.accepted(author, done, undoes)  # what cannot be accounted for is not done
        except OSError as e:
            raise BadConfiguration(f"{self._file}: the audit log cannot be written, the old values stay: {e}") from e
        try:
            if self._file is not None:
                _replace(self._file, _rewritten(self._file, {name: now for name, _before, now in done}, self._variables))
        except (OSError, BadConfiguration) as e:
            self._log.failed(author, str(e))
            raise BadConfiguration(f"{self._file}: cannot be written, the old values stay: {e}") from e
        self._values.update(parsed)
        return done

    def _parsed(self, name: str, text: str) -> Value:
        variable = self._variables.get(name)
        if variable is None:
            raise BadConfiguration(f'variable "{name}": there is none; expected one of {", ".join(self._variables)}')
        try:
            return variable.parsed(text)
        except BadConfiguration as e:
            where = f"{self._file}, " if self._file else ""
            raise BadConfiguration(f'{where}variable "{name}": {e}') from e


def _stated(file: pathlib.Path) -> Dict[str, Tuple[str, str]]:
    """Value and unit of the file's variables by name; no unit: ""."""
    stated: Dict[str, Tuple[str, str]] = {}
    for element in _root(file).iter("variable"):
        name, value = element.get("name"), element.get("value")
        if name is None or value is None:
            raise BadConfiguration(f'{file}: a <variable> lacks "name" or "value"')
        if name in stated:
            raise BadConfiguration(f'{file}, variable "{name}": appears twice')
        stated[name] = (value, element.get("unit", ""))
    return stated


def _root(file: pathlib.Path) -> ElementTree.Element:
    try:
        if file.exists() and not file.is_file():
            raise BadConfiguration(f"{file}: is not a regular file")
        with file.open(encoding="utf-8") as opened:
            text = opened.read(_MAX_CHARACTERS + 1)
        if len(text) > _MAX_CHARACTERS:
            raise BadConfiguration(f"{file}: is larger than {_MAX_CHARACTERS} characters, the maximum")
        if "<!DOCTYPE" in text:
            raise BadConfiguration(f"{file}: a DOCTYPE is not allowed here")
        builder = ElementTree.TreeBuilder(insert_comments=True)
        root = ElementTree.fromstring(text, ElementTree.XMLParser(target=builder))
    except OSError as e:
        raise BadConfiguration(f"{file}: cannot be read: {e}") from e
    except (ElementTree.ParseError, UnicodeDecodeError) as e:
        raise BadConfiguration(f"{file}: not well-formed XML: {e}") from e
    if root.tag != "configuration":
        raise BadConfiguration(f"{file}: expected <configuration>, not <{root.tag}>")
    return root


def _rewritten(file: pathlib.Path, texts: Mapping[str, str], variables: Mapping[str, Variable]) -> bytes:
    """The file's text with these values; what else it holds stays."""
    root = _root(file)
    elements = {element.get("name"): element for element in root.iter("variable")}
    for name, text in texts.items():
        element = elements.get(name)
        if element is None:
            element = ElementTree.SubElement(root, "variable", name=name, type=variables[name].type)
            element.tail = "\n"
        element.set("value", text)
    text = file.read_text(encoding="utf-8")
    before, behind = _BEFORE.match(text), _BEHIND.search(text)
    xml: str = ElementTree.tostring(root, encoding="unicode")
    return ('<?xml version="1.0" encoding="UTF-8"?>' + ((before.group(1) if before else "") or "\n") + xml
            + ((behind.group(1) if behind else "") or "\n")).encode()


def _replace(file: pathlib.Path, content: bytes) -> None:
    """After a power cut there is the old file or the new one: written beside it, synced, renamed over it."""
    target = file.resolve()
    handle, temporary = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".tmp", dir=target.parent)
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(content)
            out.flush()
            os.fsync(out.fileno())
        os.chmod(temporary, target.stat().st_mode)
        os.replace(temporary, target)
        folder = os.open(target.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)
    except BaseException:
        pathlib.Path(temporary).unlink(missing_ok=True)
        raise
