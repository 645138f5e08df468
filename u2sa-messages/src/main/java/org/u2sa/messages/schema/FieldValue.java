package org.u2sa.messages.schema;

import java.util.Optional;
import org.u2sa.messages.cbor.ByteString;

/**
 * A field as {@link U2SAData#enumerateFields()} shows it (thesis 3.2.3.1).
 *
 * @param name the field's name
 * @param unit "m", "rad", "deg", …; empty if none
 * @param value empty if absent; a number, text, {@link ByteString}, enum constant, frame, point or
 *     list of such
 */
public record FieldValue(String name, String unit, Optional<Object> value) {}
