"""What stands in the application beside its classes: resources of the libraries, services, licences; and the archive itself."""

import re
import zipfile

from .programs import Refused

SERVICES = ("META-INF/services/", "META-INF/u2sa/services")  # lists, of which every jar may have its own
# Of these the first of the class path counts, as on a desktop: each library asks for its own, and shows it at most.
FIRST_COUNTS = ("version.properties",)
TIME = (1980, 1, 1, 0, 0, 0)  # of every entry: the same input gives the same bytes

# What a phone never reads: Java's and Maven's book-keeping, other platforms' machine code, and D8's own input.
LEFT_OUT = re.compile(
    r".*/$|.*\.class$|META-INF/MANIFEST\.MF$|META-INF/[^/]+\.(SF|RSA|DSA|EC)$|META-INF/INDEX\.LIST$"
    r"|META-INF/(maven|versions|proguard|native-image|com\.android\.tools|native|jandex|sisu)/.*|META-INF/jandex\.idx$"
    r"|.*\.(kotlin_module|so|dll|jnilib|dylib|a|java)$|META-INF/.*\.versions\.properties$",
    re.IGNORECASE)
LICENCE = re.compile(r"(META-INF/)?(.*/)?([^/]*(LICEN[CS]E|NOTICE|COPYING|COPYRIGHT)[^/]*|AL2\.0|LGPL2\.1|DEPENDENCIES|about\.html|l?gpl\.txt)$", re.IGNORECASE)


def of_libraries(jars):
    """Entries by path from jars: name in the application → bytes. Lists of services of one name are joined; licences go to assets."""
    entries = {}
    owners = {}
    services = {}
    for jar in jars:
        with zipfile.ZipFile(jar) as archive:
            for name in archive.namelist():
                if LEFT_OUT.match(name):
                    continue
                content = archive.read(name)
                if name.startswith(SERVICES):
                    services.setdefault(name, []).extend(providers(content))
                    continue
                licence = LICENCE.match(name)
                path = f"assets/licences/{jar.stem}/{licence.group(3)}" if licence else name
                if path in FIRST_COUNTS and path in entries:
                    continue
                if entries.get(path, content) != content:
                    raise Refused(f"{path} is in {owners[path].name} and, with other content, in {jar.name}")
                entries[path] = content
                owners[path] = jar
    for name, classes in services.items():
        entries[name] = "".join(f"{line}\n" for line in dict.fromkeys(classes)).encode()
    return entries


def providers(content):
    """The lines of a list of services, such as a file of java.util.ServiceLoader, without comments."""
    lines = (line.split("#")[0].strip() for line in content.decode("utf-8").splitlines())
    return [line for line in lines if line]


def write(target, entries):
    """An archive whose bytes depend on the entries alone. resources.arsc stays as it is: Android maps it into memory."""
    first = ["AndroidManifest.xml", "resources.arsc"]
    names = [name for name in first if name in entries] + sorted(set(entries) - set(first))
    with zipfile.ZipFile(target, "w") as archive:
        for name in names:
            entry = zipfile.ZipInfo(name, TIME)
            entry.create_system = 0
            entry.compress_type = zipfile.ZIP_STORED if name == "resources.arsc" else zipfile.ZIP_DEFLATED
            archive.writestr(entry, entries[name])
