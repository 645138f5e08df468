"""The key that signs: a real one by option, or a debug key made on first use in a place that only its owner can read."""

import os
import secrets
import stat
from dataclasses import dataclass
from pathlib import Path

from .programs import BAD_INPUT, Refused, find, run

DEBUG_ALIAS = "u2sa-debug"
DAYS = "10950"  # 30 years, as long as Android Studio's debug key


@dataclass(frozen=True)
class Key:
    """A keystore, the file that holds its password, and the key's name in it (None: the only one there is)."""

    store: Path
    password_file: Path
    alias: str
    debug: bool


def folder():
    """Where the debug key stays: never in the repository."""
    chosen = os.environ.get("U2SA_ANDROID_KEYS")
    if chosen:
        return Path(chosen)
    return Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share") / "u2sa" / "android"


def given(store, password_file, alias):
    """A key of the user's own."""
    for option, file in (("--keystore", store), ("--keystore-password-file", password_file)):
        if file is None:
            raise Refused(f"{option} is missing; a keystore and the file with its password go together", BAD_INPUT)
        if not file.is_file():
            raise Refused(f"{option} {file}: no such file", BAD_INPUT)
    if stat.S_IMODE(password_file.stat().st_mode) & 0o077:
        raise Refused(f"--keystore-password-file {password_file}: others may read it; expected chmod 600", BAD_INPUT)
    return Key(store, password_file, alias, False)


def debug():
    """The debug key, made now if there is none. Its password is random and stands beside it."""
    place = folder()
    place.mkdir(mode=0o700, parents=True, exist_ok=True)
    if stat.S_IMODE(place.stat().st_mode) & 0o077:
        raise Refused(f"{place}: others may look into the folder of the debug key; expected chmod 700")
    store = place / "debug.keystore"
    password = place / "debug.password"
    if not (store.is_file() and password.is_file()):
        make(store, password)
    return Key(store, password, DEBUG_ALIAS, True)


def make(store, password):
    store.unlink(missing_ok=True)
    password.unlink(missing_ok=True)
    with os.fdopen(os.open(password, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
        file.write(secrets.token_urlsafe(24) + "\n")
    run([find("keytool")["keytool"], "-genkeypair", "-keystore", store, "-storetype", "PKCS12", "-storepass:file", password,
         "-alias", DEBUG_ALIAS, "-keyalg", "RSA", "-keysize", "3072", "-validity", DAYS, "-dname", "CN=U2SA debug"], "Making the debug key")
    store.chmod(0o600)


def sign(key, apk, target, min_sdk):
    """Signs by the schemes that Android from `min_sdk` on asks for."""
    alias = ["--ks-key-alias", key.alias] if key.alias else []
    run([find("apksigner")["apksigner"], "sign", "--min-sdk-version", min_sdk, "--ks", key.store, "--ks-pass", f"file:{key.password_file}",
         *alias, "--out", target, apk], "Signing")
    Path(f"{target}.idsig").unlink(missing_ok=True)


def verify(apk, min_sdk):
    """What apksigner finds: lines of its verbose answer. It refuses an application that a phone would."""
    return run([find("apksigner")["apksigner"], "verify", "--verbose", "--print-certs", "--min-sdk-version", min_sdk, apk], "Verifying").splitlines()
