"""Dex files: made by D8, counted by their headers."""

import re
import struct
import zipfile
from dataclasses import dataclass
from pathlib import Path

from .programs import Refused, find, java_program, run

# https://source.android.com/docs/core/runtime/dex-format, header_item
MAGIC = b"dex\n"
METHOD_IDS_SIZE = 0x58
CLASS_DEFS_SIZE = 0x60


@dataclass(frozen=True)
class Counts:
    """What a dex file's header says: methods it defines or calls, and classes it defines."""

    name: str
    size: int
    methods: int
    classes: int


def jar_of(archive, folder):
    """The jar itself, or the classes.jar inside an Android library (aar)."""
    if archive.suffix != ".aar":
        return archive
    target = folder / f"{archive.stem}.jar"
    with zipfile.ZipFile(archive) as library:
        target.write_bytes(library.read("classes.jar"))
    return target


def compile_jars(inputs, jars, folder):
    """Runs D8; the dex files, in order, and its warnings."""
    java = find("java")["java"]
    jdk = Path(java_program("javap") or java).resolve().parents[1]
    # With its second compiler the virtual machine takes twice the processor time for the same bytes.
    # Android's classes lack java.lang and the like here: the JDK's stand in. That a phone has them is animal-sniffer's matter.
    said = run(
        [java, "-Xmx2g", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp", inputs.r8, "com.android.tools.r8.D8", "--release", "--min-api", inputs.min_sdk,
         "--lib", jdk, "--lib", inputs.platform, "--output", folder, *jars],
        "D8")
    files = sorted(folder.glob("classes*.dex"), key=lambda file: (len(file.name), file.name))
    if not files:
        raise Refused("D8 wrote no classes.dex")
    return files, [block for block in re.split(r"\n(?=Info|Warning)", said.strip()) if block.startswith("Warning")]


def counts(name, content):
    """What the header of a dex file says."""
    if content[:4] != MAGIC:
        raise Refused(f"{name} is no dex file: it begins with {content[:8]!r}")
    return Counts(
        name, len(content), struct.unpack_from("<I", content, METHOD_IDS_SIZE)[0], struct.unpack_from("<I", content, CLASS_DEFS_SIZE)[0])


def in_apk(apk):
    """Counts of all dex files of an application."""
    with zipfile.ZipFile(apk) as archive:
        names = sorted((name for name in archive.namelist() if name.startswith("classes") and name.endswith(".dex")), key=lambda name: (len(name), name))
        return [counts(name, archive.read(name)) for name in names]
