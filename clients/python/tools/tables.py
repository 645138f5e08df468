#!/usr/bin/env python3
"""Writes u2sa/tables.py from docs/schema/u2sa-messages.json and docs/wire/labels.txt, or says with --check whether it is what those say."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent.parent
SCHEMA = HERE.parent.parent / "docs" / "schema" / "u2sa-messages.json"
LABELS = HERE.parent.parent / "docs" / "wire" / "labels.txt"
TABLES = HERE / "u2sa" / "tables.py"


def schema():
    return json.loads(SCHEMA.read_text(encoding="utf-8"))


def channel(row):
    """(name, QoS, retained, field of the source)"""
    return row["name"], row["qos"], row["retained"], row["source"]


def message(row):
    """(chain, abstract, fields); a field is (name, kind, presence, default, low, high, choices, since, longest, shortens)."""
    return tuple(row["chain"]), row["abstract"], [field(each) for each in row["fields"]]


def field(row):
    kind = row["kind"] + (":" + row["element"] if "element" in row else "")
    default = row.get("default")
    return (row["name"], kind, row["presence"], () if default == [] else default, row.get("min"), row.get("max"),
            tuple(row.get("constants", ())), row["since"], row.get("maxLength"), row.get("shortens", False))


def standard(rows):
    """Those of every system."""
    return [row for row in rows if not row["system"]]


def written():
    whole = schema()
    out = ['"""Channels and messages, written by tools/tables.py from docs/schema/u2sa-messages.json and docs/wire/labels.txt. Do not edit."""', ""]
    out += ["# name: (QoS, retained, field that names the source in the topic)", "CHANNELS = {"]
    out += [f"    {name!r}: ({qos}, {retained}, {source!r})," for name, qos, retained, source in map(channel, standard(whole["channels"]))]
    out += ["}", ""]
    out += ["# (type chain, abstract, fields); a field: (name, kind, presence, default, least, most, constants, since, longest, shortens)"]
    out += ["MESSAGES = ["]
    for chain, abstract, fields in map(message, standard(whole["messages"])):
        out += [f"    ({chain!r}, {abstract}, ["]
        out += [f"        {each!r}," for each in fields]
        out += ["    ]),"]
    out += ["]", "", "# names of fields; each one's place is its label", "LABELS = ("]
    out += [f"    {line.split()[1]!r}," for line in LABELS.read_text(encoding="utf-8").splitlines()]
    out += [")", ""]
    return "\n".join(out)


def main():
    if sys.argv[1:] == ["--check"]:
        if TABLES.read_text(encoding="utf-8") != written():
            sys.exit("clients/python/u2sa/tables.py is not what docs/schema/u2sa-messages.json and docs/wire/labels.txt say: "
                     "run python3 clients/python/tools/tables.py")
        return
    TABLES.write_text(written(), encoding="utf-8")


if __name__ == "__main__":
    main()
