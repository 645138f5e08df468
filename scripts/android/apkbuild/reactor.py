"""What Maven builds for the phone: the application's jar, all that it needs at run time, D8, and Android's own classes."""

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

from .programs import HOME, Refused, find, run

MODULE = HOME / "u2sa-android"
BUILT = MODULE / "target" / "apk"
POM = "{http://maven.apache.org/POM/4.0.0}"
# Where the repository's files go in the application: the same paths, below assets.
ASSET_FOLDERS = ("config/ugv", "missions/ugv")


@dataclass(frozen=True)
class Inputs:
    """Everything an APK is made of."""

    class_path: list  # jars and aars, the application's own first
    platform: Path  # Android's classes and resources, in place of an SDK's android.jar
    r8: Path  # the jar that holds D8
    manifest: Path
    resources: Path
    version_name: str
    version_code: int
    min_sdk: int


def build():
    """Compiles and packages the modules (no tests), and says where everything is."""
    programs = find("mvn", "java")
    log = run(
        [programs["mvn"], "-q", "-B", "-Dstyle.color=never", "-Papk", "-pl", "u2sa-android", "-am", "package"],
        "Maven's build", cwd=HOME)
    if "[ERROR]" in log:
        raise Refused(f"Maven's build failed: {log}")
    return inputs()


def inputs():
    """The inputs as the last build left them."""
    application = MODULE / "target" / f"u2sa-android-{version_name()}.jar"
    gradle = (MODULE / "build.gradle.kts").read_text(encoding="utf-8")
    manifest = MODULE / "src" / "main" / "AndroidManifest.xml"
    for name, level in (("min", number("minSdk", gradle)), ("target", number("targetSdk", gradle))):
        if f'android:{name}SdkVersion="{level}"' not in manifest.read_text(encoding="utf-8"):
            raise Refused(f"{manifest}: its {name}SdkVersion is not the {level} of build.gradle.kts")
    platform = paths_in("platform.classpath")
    if len(platform) != 1:
        raise Refused(f"{BUILT / 'platform.classpath'} names {len(platform)} jars; expected android-all alone")
    return Inputs(
        class_path=[application] + paths_in("runtime.classpath"),
        platform=platform[0],
        r8=BUILT / "r8.jar",
        manifest=manifest,
        resources=MODULE / "src" / "main" / "res",
        version_name=version_name(),
        version_code=number("versionCode", gradle),
        min_sdk=number("minSdk", gradle))


def paths_in(name):
    file = BUILT / name
    if not file.is_file():
        raise Refused(f"{file} is missing; expected Maven's profile apk to write it")
    return [Path(path) for path in file.read_text(encoding="utf-8").strip().split(":") if path]


def version_name():
    """The project's version, from the root pom."""
    return ElementTree.parse(HOME / "pom.xml").getroot().findtext(f"{POM}version")


def number(name, gradle):
    """A number that the Gradle build gives the application: both builds read the one file."""
    found = re.search(rf"^\s*{name} = (\d+)\s*$", gradle, re.MULTILINE)
    if not found:
        raise Refused(f'{MODULE / "build.gradle.kts"} has no line "{name} = NUMBER"')
    return int(found.group(1))


def assets():
    """Pairs of path in the application and file, sorted: the repository's UGV files and the module's own assets."""
    pairs = []
    own = MODULE / "src" / "main" / "assets"
    for folder in ASSET_FOLDERS:
        pairs += [(f"assets/{file.relative_to(HOME).as_posix()}", file) for file in (HOME / folder).rglob("*") if shipped(file)]
    if own.is_dir():
        pairs += [(f"assets/{file.relative_to(own).as_posix()}", file) for file in own.rglob("*") if shipped(file)]
    return sorted(pairs)


def shipped(file):
    """Whether a file is part of the application: not what a run left beside it (docs/remote-configuration.md)."""
    return file.is_file() and not file.name.startswith(".") and not file.name.endswith(".audit.jsonl")
