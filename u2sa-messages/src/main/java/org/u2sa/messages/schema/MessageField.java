package org.u2sa.messages.schema;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * One field of a message class: declared once in its {@link Schema}; codec, enumeration, presence,
 * equality and XML follow. Immutable.
 *
 * @param <T> the message class that declares or inherits the field
 */
public abstract class MessageField<T extends U2SAData> {
  static final int NO_BIT = -1;

  final int slot; // index in the message's storage
  final int bit; // in the presence vector, or NO_BIT
  private final String owner;
  private final String name;
  private final Kind kind;
  private final String unit;
  private final FieldPresence presence;
  private final int since;

  MessageField(FieldOutline outline, Kind kind) {
    owner = outline.owner();
    name = outline.name();
    this.kind = kind;
    unit = outline.unit();
    presence = outline.presence();
    slot = outline.slot();
    bit = outline.bit();
    since = outline.since();
  }

  /** Name in code, XML and on the wire. */
  public final String name() {
    return name;
  }

  /** What it holds. */
  public final Kind kind() {
    return kind;
  }

  /**
   * "m", "rad", "m/s", …; empty if it has none. For the coordinates x and y see {@link #unitIn}.
   */
  public final String unit() {
    return unit;
  }

  /** The unit in this very message: x and y in GLOBAL are "deg", else "m". */
  public String unitIn(T message) {
    return unit;
  }

  /** The unit that the field has in messages written in the given frame. */
  public String unitIn(ReferenceFrame frame) {
    return unit;
  }

  /** True if a message may be published without it. */
  public final boolean isOptional() {
    return presence == FieldPresence.OPTIONAL;
  }

  /**
   * True if a message may not be published without it; neither optional nor required fields have a
   * default.
   */
  public final boolean isRequired() {
    return presence == FieldPresence.REQUIRED;
  }

  /**
   * Its bit in {@link U2SAData#presenceVector()}; empty for fields that have none (texts, lists,
   * whatever is not optional).
   */
  public final OptionalInt bit() {
    return bit == NO_BIT ? OptionalInt.empty() : OptionalInt.of(bit);
  }

  /** Version of the wire format that brought the field; counts from 1. */
  public final int since() {
    return since;
  }

  /** The value, or its default; empty if absent. */
  public abstract Optional<Object> get(T message);

  /** True if the value was set, be it to its default. */
  public abstract boolean isSet(T message);

  /**
   * Sets the value.
   *
   * @throws IllegalArgumentException naming field, value and what was expected
   * @throws IllegalStateException if the message is frozen
   */
  public abstract void set(T message, Object value);

  /**
   * Sets the value from the text of an XML element or an operator. Lists of texts are split at
   * commas; bytes are in base64; points are two or three numbers separated by blanks or commas,
   * lists of points separate them by semicolons.
   *
   * @throws IllegalArgumentException naming field, text and what was expected
   * @throws IllegalStateException if the message is frozen
   */
  public abstract void setText(T message, String text);

  /**
   * As {@link #setText} for an element that is given several times, as {@code <next>} may be: a
   * list of texts takes all.
   */
  public abstract void setTexts(T message, List<String> texts);

  /** True if an encoder must write the field. */
  abstract boolean isWritten(T message);

  /** Reads the value; false if it was passed over as one that only later readers know. */
  abstract boolean read(CborReader in, T message) throws MalformedMessageException;

  /** "Waypoint.x", for errors. */
  final String path() {
    return owner + "." + name;
  }

  final IllegalArgumentException refused(Object value, String what) {
    return new IllegalArgumentException(path() + ": " + what + ", not \"" + brief(value) + "\"");
  }

  private static String brief(Object value) {
    String text = String.valueOf(value);
    return text.length() <= 80 ? text : text.substring(0, 80) + "…";
  }

  /** "Waypoint.x [m]". */
  @Override
  public final String toString() {
    return unit.isEmpty() ? path() : path() + " [" + unit + "]";
  }
}
