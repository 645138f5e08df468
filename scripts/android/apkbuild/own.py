"""Jars of the user's own services, which go into the application beside U2SA's."""

import zipfile

from .programs import BAD_INPUT, Refused


def checked(jars):
    """The jars, if each holds classes; refuses what is none before anything is built."""
    for jar in jars:
        if not jar.is_file():
            raise Refused(f"--with {jar}: no such file", BAD_INPUT)
        if not any(classes(jar)):
            raise Refused(f"--with {jar}: holds no classes; expected the jar of your services", BAD_INPUT)
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


def classes(jar):
    """The classes of a jar, by their places in it."""
    try:
        with zipfile.ZipFile(jar) as archive:
            names = archive.namelist()
    except zipfile.BadZipFile as error:
        raise Refused(f"{jar}: is no jar ({error})", BAD_INPUT) from error
    return [name for name in names if name.endswith(".class") and not name.startswith("META-INF/") and not name.endswith("module-info.class")]
