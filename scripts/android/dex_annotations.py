"""What enjarify leaves out of a dex file: runtime annotations, their defaults, and the names of parameters.

Written as a stream that proof/DexAnnotations.java reads. Format of dex: source.android.com/docs/core/runtime/dex-format.
"""

import struct

from enjarify.parsedex import MethodId

RUNTIME, SYSTEM = 1, 2
DEFAULTS = b"Ldalvik/annotation/AnnotationDefault;"
PARAMETERS = b"Ldalvik/annotation/MethodParameters;"
NUMBERS = {0x00: b"B", 0x02: b"S", 0x03: b"C", 0x04: b"I", 0x06: b"J", 0x10: b"F", 0x11: b"D"}
SIGNED = b"BSIJ"


def utf(text):
    """As DataInput.readUTF has it: dex keeps texts in the same modified UTF-8."""
    return struct.pack(">H", len(text)) + text


def value(dex, stream):
    """One encoded_value, as a tag and its content."""
    head = stream.u8()
    kind, size = head & 31, (head >> 5) + 1
    if kind == 0x1C:
        return b"[" + struct.pack(">H", count := stream.uleb128()) + b"".join(value(dex, stream) for _ in range(count))
    if kind == 0x1D:
        return b"@" + annotation(dex, stream)[1]
    if kind == 0x1E:  # no name of a parameter
        return b"n"
    if kind == 0x1F:
        return b"Z" + struct.pack(">Q", size - 1)
    content = bytes(stream.u8() for _ in range(size))
    if kind in NUMBERS:
        tag = NUMBERS[kind]
        if tag in b"FD":  # extended by zeros to the right
            bits = int.from_bytes(content.rjust(4 if tag == b"F" else 8, b"\0"), "little")
        else:
            bits = int.from_bytes(content, "little", signed=tag in SIGNED) % (1 << 64)
        return tag + struct.pack(">Q", bits)
    index = int.from_bytes(content, "little")
    if kind == 0x17:
        return b"s" + utf(dex.string(index))
    if kind == 0x18:
        return b"c" + utf(dex.type(index))
    if kind == 0x1B:
        field = dex.stream(dex.field_ids.off + index * 8)
        field.u16()
        return b"e" + utf(dex.type(field.u16())) + utf(dex.string(field.u32()))
    return b"?"  # such as an enclosing method: of the system's own annotations only, so whoever reads one refuses it


def annotation(dex, stream):
    """An encoded_annotation: its type, and all of it as written."""
    kind = dex.type(stream.uleb128())
    elements = [(dex.string(stream.uleb128()), value(dex, stream)) for _ in range(stream.uleb128())]
    return kind, utf(kind) + struct.pack(">H", len(elements)) + b"".join(utf(name) + content for name, content in elements), elements


def annotations(dex, offset):
    """Those of an annotation_set_item: visibility, type, as written, elements."""
    if offset == 0:
        return
    items = dex.stream(offset)
    for _ in range(items.u32()):
        item = dex.stream(items.u32())
        yield item.u8(), *annotation(dex, item)


def names(content):
    """The texts of an array of texts; none at all if one is absent."""
    texts, at = [], 3
    for _ in range(struct.unpack_from(">H", content, 1)[0]):
        if content[at : at + 1] == b"n":
            return []
        (length,) = struct.unpack_from(">H", content, at + 1)
        texts.append(content[at + 3 : at + 3 + length])
        at += 3 + length
    return texts


def records(dex):
    """All of a dex file: class annotations, defaults, names of parameters and annotations on them."""
    for number, one in enumerate(dex.classes):
        directory = dex.stream(dex.class_defs.off + number * 32 + 20).u32()
        if directory == 0:
            continue
        stream = dex.stream(directory)
        on_class, fields, methods, parameters = (stream.u32() for _ in range(4))
        owner = utf(one.name)
        for visibility, kind, written, elements in annotations(dex, on_class):
            if visibility == RUNTIME:
                yield b"K" + owner + written
            elif kind == DEFAULTS:
                defaults = elements[0][1][1:]  # the annotation within, without its tag
                yield b"D" + owner + defaults
        for _ in range(fields):
            stream.u32()
            stream.u32()
        for _ in range(methods):
            method = MethodId(dex, stream.u32())
            for visibility, kind, written, elements in annotations(dex, stream.u32()):
                if visibility == SYSTEM and kind == PARAMETERS:
                    texts = names(dict(elements)[b"names"])
                    yield b"N" + owner + utf(method.name) + utf(method.desc) + struct.pack(">H", len(texts)) + b"".join(map(utf, texts))
        for _ in range(parameters):
            method = MethodId(dex, stream.u32())
            sets = dex.stream(stream.u32())
            for index in range(sets.u32()):
                for visibility, kind, written, elements in annotations(dex, sets.u32()):
                    if visibility == RUNTIME:
                        yield b"P" + owner + utf(method.name) + utf(method.desc) + struct.pack(">H", index) + written
