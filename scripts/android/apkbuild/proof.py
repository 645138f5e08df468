"""Turns an application's dex files back into class files, and runs the demos' missions on them as a phone would see them."""

import json
import re
import shutil
import subprocess
import sys
import zipfile
from dataclasses import dataclass
from pathlib import Path

from . import contents, reactor
from .programs import HOME, Refused, find, java_program, run

SCRIPTS = HOME / "scripts" / "android"
TOOLS = reactor.BUILT / "proof"
SIGNATURES = TOOLS / "gummy-bears-api-26.signature"
MAIN = "org.u2sa.cli.Main"
# The demos whose vehicles a phone can carry: the camera's perception of demo igvc is not in the application.
DEMOS = ("cessna", "ugv")
# What a run's speed decides, not its mission.
WALL_CLOCK = ("wallSeconds", "simSecondsPerSecond")
# What is named that API 26 lacks, and why it does no harm. Everything else of Java's or Android's must be in the signatures.
HARMLESS = (
    (r"org\.locationtech\.jts\.awt\.", "drawing with AWT"),
    (r"org\.ejml\.dense\.row\.DMatrix(Component|Visualization) ", "a window that shows a matrix"),
    (r"io\.netty\.handler\.ssl\.", "Netty's own TLS engines and self-signed certificates: the broker asks for the platform's"),
    (r"org\.h2\.util\.Utils ", "statistics of the database's memory"),
    (r"com\.fasterxml\.jackson\.databind\.ext\.Java7SupportImpl ", "beans' annotations, asked for behind a catch"),
    (r"com\.fasterxml\.jackson\.dataformat\.xml\.util\.StaxUtil ", "finding an XML reader: XmlParser names its own"),
    (r"org\.u2sa\.android\..* android\..* asked$", "of later Androids, called after asking for the API level"),
    (r"org\.u2sa\.android\..* android\.(view\.View|widget\.\w+)\.setAccessibilityHeading\(", "API 28, our own limit"),
    (r"org\.u2sa\.android\..* android\.\S*\.getMainExecutor\(", "API 28, our own limit"),
)
PLATFORM = re.compile(r" (java|javax|sun|jdk|android|dalvik|com\.sun)\.")


@dataclass(frozen=True)
class Flight:
    """What came of a mission: its track, and its summary without what the wall clock says."""

    track: bytes
    summary: dict


def prepare():
    """Compiles the programs of this proof; the command that starts a virtual machine with them."""
    if not SIGNATURES.is_file():
        reactor.build()
    classes = TOOLS / "classes"
    shutil.rmtree(classes, ignore_errors=True)
    javac = java_program("javac")
    if javac is None:
        raise Refused("found no javac; expected a JDK 17 or newer (apt install openjdk-17-jdk-headless)")
    run([javac, "-d", classes, "-cp", library_path(), *sorted((SCRIPTS / "proof").glob("*.java"))], "Compiling the proof")
    # As in dex.py: the second compiler costs more processor time than it saves.
    return [find("java")["java"], "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp", f"{classes}:{library_path()}"]


def library_path():
    return f"{TOOLS / 'asm.jar'}:{TOOLS / 'animal-sniffer.jar'}"


def translate(java, apk, folder):
    """The application's classes as a jar that a desktop's virtual machine verifies and runs."""
    python = python_with_enjarify()
    print(run([python, "-O", SCRIPTS / "dex-to-class", apk, folder / "old.jar"], "Translating dex back").splitlines()[-1])
    run([*java, "ModernClassFiles", folder / "old.jar", folder / "phone.jar"], "Lifting the class files")
    return folder / "phone.jar"


def python_with_enjarify():
    for python in (sys.executable, "/usr/bin/python3"):
        if Path(python).is_file() and subprocess.run([python, "-c", "import enjarify"], capture_output=True, check=False).returncode == 0:
            return python
    raise Refused("found no enjarify, which turns dex files back into class files; expected Debian's (apt install enjarify)")


def check_services(apk, jar):
    """Refuses lists of services with a name without a class."""
    with zipfile.ZipFile(apk) as resources, zipfile.ZipFile(jar) as classes:
        there = set(classes.namelist())
        for name in resources.namelist():
            if name.startswith(contents.SERVICES):
                for line in contents.providers(resources.read(name)):
                    provider = line.split()[-1]  # in a list for swaps, after the role
                    if provider.replace(".", "/") + ".class" not in there:
                        raise Refused(f"{name} names {provider}, which is no class of the application", 1)


def check_api(java, jar):
    """Refuses classes of the application that call what a phone lacks."""
    lines = [line for line in run([*java, "ApiCheck", SIGNATURES, jar], "Comparing with the API").splitlines() if PLATFORM.search(line)]
    unexpected = [line for line in lines if not any(re.match(pattern, line) for pattern, _ in HARMLESS)]
    if unexpected:
        raise Refused("not on a phone:\n  " + "\n  ".join(unexpected))
    return len(lines)


def desktop_jars():
    """The command line's jars that are not part of the application."""
    run([HOME / "u2sa", "--version"], "Building the command line")
    phone = {path.name for path in reactor.inputs().class_path}
    jars = sorted((HOME / "target" / "u2sa" / "lib").glob("*.jar"))
    return [jar for jar in jars if jar.name not in phone and not jar.name.startswith("logback")]


def fly_desktop(demo, seed, folder):
    """The mission as ./u2sa runs it."""
    run([HOME / "u2sa", "demo", demo, "--seed", seed, "--out", folder], f"The demo {demo}")
    return flight(folder)


def fly_phone(java, jar, apk, demo, seed, folder):
    """The same mission on the application's classes; and the report of what they found."""
    report = folder.parent / f"{folder.name}.report"
    desktop = ":".join(str(path) for path in desktop_jars())
    run([*java[:-2], "-Djava.awt.headless=true", "-Dfile.encoding=UTF-8", f"-Du2sa.home={HOME}",
         "-Dslf4j.provider=org.slf4j.helpers.NOP_FallbackServiceProvider", *java[-2:],
         "PhoneRun", SIGNATURES, report, f"{jar}:{apk}", desktop, MAIN, "demo", demo, "--seed", seed, "--out", folder],
        f"The demo {demo} on the application's classes")
    return flight(folder), report.read_text(encoding="utf-8").splitlines()


def flight(folder):
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return Flight((folder / "track.csv").read_bytes(), {name: value for name, value in summary.items() if name not in WALL_CLOCK})
