#!/usr/bin/env python3
"""Writes u2sa/tables.py from docs/schema/u2sa-messages.json, or says with --check whether it is what that says."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent.parent
SCHEMA = HERE.parent.parent / "docs" / "schema" / "u2sa-messages.json"
TABLES = HERE / "u2sa" / "tables.py"


def schema():
    return json.loads(SCHEMA.read_text(encoding="utf-8"))


def channel(row):
    """(name, QoS, retained, field of the source)"""
    return row["name"], row["qos"], row["retained"], row["source"]


def message(row):
    """(chain, abstract, fields); a field is (name, kind, presence, default, low, high, choices, since)."""
    return tuple(row["chain"]), row["abstract"], [field(each) for each in row["fields"]]


def field(row):
    kind = row["kind"] + (":" + row["element"] if "element" in row else "")
    default = row.get("default")
    return (row["name"], kind, row["presence"], () if default == [] else default, row.get("min"), row.get("max"),
            tuple(row.get("constants", ())), row["since"])


def standard(rows):
    """Those of every system."""
    return [row for row in rows if not row["system"]]


def written():
    whole = schema()
    out = ['"""Channels and messages, written by tools/tables.py from docs/schema/u2sa-messages.json. Do not edit."""', ""]
    out += ["# name: (QoS, retained, field that names the source in the topic)", "CHANNELS = {"]
    out += [f"    {name!r}: ({qos}, {retained}, {source!r})," for name, qos, retained, source in map(channel, standard(whole["channels"]))]
    out += ["}", ""]
    out += ["# (type chain, abstract, fields); a field: (name, kind, presence, default, least, most, constants, since)"]
    out += ["MESSAGES = ["]
    for chain, abstract, fields in map(message, standard(whole["messages"])):
        out += [f"    ({chain!r}, {abstract}, ["]
        out += [f"        {each!r}," for each in fields]
        out += ["    ]),"]
    out += ["]", ""]
    return "\n".join(out)


def main():
    if sys.argv[1:] == ["--check"]:
        if TABLES.read_text(encoding="utf-8") != written():
            sys.exit("clients/python/u2sa/tables.py is not what docs/schema/u2sa-messages.json says: "
                     "run python3 clients/python/tools/tables.py")
        return
    TABLES.write_text(written(), encoding="utf-8")


if __name__ == "__main__":
    main()
