package org.u2sa.messages.schema;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * One field of a message class: declared once in its {@link Schema}; codec, enumeration, presence,
 * equality and XML follow. Immutable.
 *
 * @param <T> the message class that declares or inherits the field
 */
public abstract class MessageField<T extends StoredMessage> {
  /** Properties common to all kinds of fields, passed by the schema. */
  record Outline(
      String owner, String name, String unit, Presence presence, int slot, int bit, int since) {
    static final int NO_BIT = -1;

    enum Presence {
      /** May be absent; absence is not encoded as 0 or NaN. */
      OPTIONAL,
      /** Required for publishing and decoding. */
      REQUIRED,
      /** Has a default; always written. */
      DEFAULTED
    }
  }

  final int slot; // index in the message's storage
  final int bit; // in the presence vector, or Outline.NO_BIT
  private final String owner;
  private final String name;
  private final Kind kind;
  private final String unit;
  private final Outline.Presence presence;
  private final int since;

  MessageField(Outline outline, Kind kind) {
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

  /** Kind of value. */
  public final Kind kind() {
    return kind;
  }

  /** Unit: "m", "rad", "m/s", …; empty if none. For the coordinates x and y see {@link #unitIn}. */
  public final String unit() {
    return unit;
  }

  /** Unit in this message: "deg" for x and y in GLOBAL, else "m". */
  public String unitIn(T message) {
    return unit;
  }

  /** Unit in messages of the given frame. */
  public String unitIn(ReferenceFrame frame) {
    return unit;
  }

  /** Whether it may be absent from a published message. */
  public final boolean isOptional() {
    return presence == Outline.Presence.OPTIONAL;
  }

  /**
   * Whether a message cannot be published without it; optional and required fields have no default.
   */
  public final boolean isRequired() {
    return presence == Outline.Presence.REQUIRED;
  }

  /**
   * Its bit in {@link U2SAData#presenceVector()}; empty for fields without one (texts, lists, and
   * all that are not optional).
   */
  public final OptionalInt bit() {
    return bit == Outline.NO_BIT ? OptionalInt.empty() : OptionalInt.of(bit);
  }

  /** Wire format version that introduced the field, from 1. */
  public final int since() {
    return since;
  }

  /** The value, or its default; empty if absent. */
  public abstract Optional<Object> get(T message);

  /** Whether the value was set explicitly, even to its default. */
  public abstract boolean isSet(T message);

  /**
   * Sets the value.
   *
   * @throws IllegalArgumentException naming field, value and what was expected
   * @throws IllegalStateException if the message is frozen
   */
  public abstract void set(T message, Object value);

  /**
   * Parses the value from an XML element or operator input. Lists of texts are comma-separated;
   * bytes are base64; points are two or three numbers separated by blanks or commas, and lists of
   * points are separated by semicolons.
   *
   * @throws IllegalArgumentException naming field, text and what was expected
   * @throws IllegalStateException if the message is frozen
   */
  public abstract void setText(T message, String text);

  /**
   * Like {@link #setText} for repeatable elements such as {@code <next>}: a list of texts takes
   * all.
   */
  public abstract void setTexts(T message, List<String> texts);

  /** Storage to put a value into; throws if the message is frozen. */
  final FieldStorage thawed(StoredMessage message) {
    FieldStorage storage = message.storage;
    if (storage.isFrozen()) {
      throw new IllegalStateException(
          path() + " cannot be set: the message was frozen when it was published; copy() it");
    }
    return storage;
  }

  /** Reads the value; false if skipped because only later versions define it. */
  abstract boolean read(CborReader in, T message) throws MalformedMessageException;

  /** "Waypoint.x", for errors. */
  public final String path() {
    return owner + "." + name;
  }

  final IllegalArgumentException refused(Object value, String what) {
    String quoted = "\"" + brief(value) + "\"";
    return new IllegalArgumentException(
        path() + ": " + what + (what.startsWith(quoted) ? "" : ", not " + quoted));
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
