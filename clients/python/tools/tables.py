#!/usr/bin/env python3
"""Writes u2sa/tables.py from the tables of docs/wire-protocol.md, or says with --check whether it is what they say."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent.parent
DOC = HERE.parent.parent / "docs" / "wire-protocol.md"
TABLES = HERE / "u2sa" / "tables.py"


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def channels(text):
    """(name, QoS, retained, field of the source) of each channel of the first table."""
    lines = text[text.index("| channel |"):].splitlines()[2:]
    rows = []
    for line in lines:
        if not line.startswith("|"):
            break
        name, _types, _way, qos, retained = cells(line)
        rows.append((name, int(qos), retained != "", retained[len("of each "):]))
    return rows


def messages(text):
    """(chain, abstract, fields) of each message; a field is (name, kind, presence, default, low, high, choices, since)."""
    found = []
    for section in re.split(r"^### ", text, flags=re.M)[1:]:
        chain = re.search(r"Type chain `([^`]+)`(, abstract)?", section)
        if not chain:
            continue
        rows = [cells(line) for line in section.splitlines() if line.startswith("|")][2:]
        fields = [field(*row[:6]) for row in rows]
        found.append((tuple(chain.group(1).split("/")), bool(chain.group(2)), fields))
    return found


def field(name, cbor, _unit, presence, _bit, since):
    kind, low, high, choices = cbor, None, None, ()
    if cbor.startswith("text: "):
        kind, choices = "enum", tuple(cbor[len("text: "):].split(", "))
    elif cbor.startswith("float64, ≥ "):
        kind, low = "float64", float(cbor[len("float64, ≥ "):])
    elif cbor.startswith("float64, "):
        kind = "float64"
        low, high = (float(end) for end in cbor[len("float64, "):].split("…"))
    elif cbor == "text (frame)":
        kind = "frame"
    elif cbor == "array of 3 float64":
        kind = "point"
    elif cbor == "array of text":
        kind = "texts"
    elif cbor == "array of float64":
        kind = "numbers"
    elif cbor == "array of bool":
        kind = "flags"
    elif cbor == "array of points":
        kind = "points"
    elif cbor.startswith("array of "):
        kind = "messages:" + cbor[len("array of "):-len(" maps")]
    elif kind not in ("text", "int", "bool", "float64"):
        raise ValueError(f"{name}: the table says \"{cbor}\", which no reader knows")
    default = None
    if presence.startswith("always; "):
        text = presence[len("always; "):-len(" unless set")]
        presence = "always"
        default = parsed(text, kind)
    return (name, kind, presence, default, low, high, choices, int(since))


def parsed(text, kind):
    if kind == "float64":
        return float(text)
    if kind == "int":
        return int(text)
    if kind == "bool":
        return text == "true"
    if kind in ("texts", "numbers", "flags", "points") or kind.startswith("messages"):
        return ()
    return "" if text == '""' else text


def written():
    text = DOC.read_text(encoding="utf-8")
    out = ['"""Channels and messages, written by tools/tables.py from docs/wire-protocol.md. Do not edit."""', ""]
    out += ["# name: (QoS, retained, field that names the source in the topic)", "CHANNELS = {"]
    out += [f"    {name!r}: ({qos}, {retained}, {source!r})," for name, qos, retained, source in channels(text)]
    out += ["}", ""]
    out += ["# (type chain, abstract, fields); a field: (name, kind, presence, default, least, most, constants, since)"]
    out += ["MESSAGES = ["]
    for chain, abstract, fields in messages(text):
        out += [f"    ({chain!r}, {abstract}, ["]
        out += [f"        {each!r}," for each in fields]
        out += ["    ]),"]
    out += ["]", ""]
    return "\n".join(out)


def main():
    if sys.argv[1:] == ["--check"]:
        if TABLES.read_text(encoding="utf-8") != written():
            sys.exit("clients/python/u2sa/tables.py is not what docs/wire-protocol.md says: "
                     "run python3 clients/python/tools/tables.py")
        return
    TABLES.write_text(written(), encoding="utf-8")


if __name__ == "__main__":
    main()
