"""Jars of the user's own services, which go into the application beside U2SA's."""

import re
import zipfile

from .programs import BAD_INPUT, Refused

# What Android itself reads: bytecode beside D8's, the manifest, compiled resources, native libraries.
APPLICATIONS = re.compile(r"classes[0-9]*\.dex|AndroidManifest\.xml|resources\.arsc|(res|lib)/.+", re.IGNORECASE)


def checked(jars):
    """The jars, if each holds classes; refuses what is none before anything is built."""
    for jar in jars:
        if not jar.is_file():
            raise Refused(f"--with {jar}: no such file", BAD_INPUT)
        if not any(classes(jar)):
            raise Refused(f"--with {jar}: holds no classes; expected the jar of your services", BAD_INPUT)
        for name in entries(jar):
            if APPLICATIONS.fullmatch(name):
                raise Refused(f"--with {jar}: {name} would become part of the application unseen; expected classes, resources of theirs and "
                              "META-INF/services", BAD_INPUT)
    names = [jar.name for jar in jars]
    if len(set(names)) != len(names):
        raise Refused(f"--with {' '.join(names)}: two jars of one name", BAD_INPUT)
    return jars


def beside(jars, application):
    """Refuses classes that the application has already: D8 takes each once."""
    owners = {}
    for jar in [*application, *jars]:
        for name in classes(jar):
            if jar in jars and name in owners:
                raise Refused(
                    f"--with {jar}: {name} is in {owners[name].name}, too; expected your own classes only, "
                    "with the libraries that the application lacks", BAD_INPUT)
            owners.setdefault(name, jar)


def replacing_nothing(jars, application):
    """Refuses files that the application has, by their names in it."""
    for jar in jars:
        for name in entries(jar):
            if name in application:
                raise Refused(f"--with {jar}: {name} is one of the application's own files; expected another name", BAD_INPUT)


def entries(jar):
    """The names of all that a jar holds."""
    try:
        with zipfile.ZipFile(jar) as archive:
            return archive.namelist()
    except zipfile.BadZipFile as error:
        raise Refused(f"{jar}: is no jar ({error})", BAD_INPUT) from error


def classes(jar):
    """The classes of a jar, by their places in it."""
    return [name for name in entries(jar) if name.endswith(".class") and not name.startswith("META-INF/") and not name.endswith("module-info.class")]
