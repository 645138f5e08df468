"""Finds and runs the programs that the build needs; says which Debian package brings a missing one."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

HOME = Path(__file__).resolve().parents[3]  # the repository

BAD_INPUT = 2
CANNOT_BUILD = 3  # as of ./u2sa: a program is missing, or the build failed

# Which Debian package brings a program; those not named here are packages of the same name.
PACKAGES = {"mvn": "maven", "java": "openjdk-17-jdk-headless", "keytool": "openjdk-17-jdk-headless", "javap": "openjdk-17-jdk-headless"}


class Refused(Exception):
    """Ends the build with one line; `code` is the exit code."""

    def __init__(self, message, code=CANNOT_BUILD):
        super().__init__(message)
        self.code = code


def java_program(name):
    """Path of a program of the JDK: the one of JAVA_HOME, else the one on the path."""
    chosen = os.environ.get("JAVA_HOME")
    if chosen:
        path = Path(chosen) / "bin" / name
        if not path.is_file():
            raise Refused(f'JAVA_HOME is "{chosen}", but {path} is no program; expected the folder of a JDK 17 or newer')
        return str(path)
    return shutil.which(name)


def find(*names):
    """Paths of programs by name. Names all that are missing, and their packages, in one line."""
    paths = {name: java_program(name) if name in ("java", "keytool", "javap") else shutil.which(name) for name in names}
    missing = [name for name, path in paths.items() if path is None]
    if missing:
        packages = " ".join(sorted({PACKAGES.get(name, name) for name in missing}))
        raise Refused(f"found no {', no '.join(missing)}; expected Debian's programs (apt install {packages})")
    return paths


def run(arguments, what, **options):
    """Runs a program to its end; its output. Shows it all where the program failed."""
    done = subprocess.run(
        [str(argument) for argument in arguments],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    if done.returncode != 0:
        sys.stderr.write(done.stdout)
        raise Refused(f"{what} failed: {Path(arguments[0]).name} ended with {done.returncode}")
    return done.stdout
