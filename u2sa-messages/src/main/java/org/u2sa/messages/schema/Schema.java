package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageField.Outline.Presence;

/**
 * Declares the fields of one message class, one per line, in wire order; only used in the class's
 * static initialiser. Append new fields at the end, after a call of {@link #since}.
 *
 * <pre>{@code
 * private static final Schema<Beacon> SCHEMA = Schema.of(Beacon.class, Beacon::new, ObjectDescription.TYPE);
 * private static final NumberField<Beacon> RANGE = SCHEMA.optionalNumber("range", "m");
 * public static final MessageType<Beacon> TYPE = SCHEMA.build();
 * }</pre>
 *
 * <p>An optional number, flag or enum gets the next bit of the presence vector. Optional texts have
 * no bit.
 *
 * @param <T> the message class
 */
public final class Schema<T extends U2SAData> {
  private static final double ANY_LESS = Double.NEGATIVE_INFINITY;
  private static final double ANY_MORE = Double.POSITIVE_INFINITY;

  private final MessageType.Identity<T> identity;
  private final List<MessageField<T>> fields = new ArrayList<>();
  private final Map<String, String> aliases = new HashMap<>();
  private final Map<MessageField<?>, MessageType<?>> elements = new HashMap<>();
  private final FieldSlots slots;
  private ValueField<?, ReferenceFrame> frameField; // null: none
  private int since = 1;

  private Schema(MessageType.Identity<T> identity) {
    this.identity = identity;
    MessageType<? super T> parent = identity.parent();
    if (parent == null) {
      slots = new FieldSlots();
      return;
    }
    slots = FieldSlots.after(parent.sizes);
    for (MessageField<? super T> field : parent.fields()) {
      fields.add(MessageType.inherited(field));
    }
    aliases.putAll(parent.aliases);
    elements.putAll(parent.elements);
    frameField = parent.frameField;
  }

  /**
   * Creates the schema of a concrete class, named by its simple name in topics and XML.
   *
   * @param empty creates an empty message
   */
  public static <T extends U2SAData> Schema<T> of(
      Class<T> messageClass, Supplier<T> empty, MessageType<? super T> parent) {
    return of(messageClass.getSimpleName(), messageClass, empty, parent);
  }

  /** Like {@link #of} with an explicit name, for a class that stands for one of another program. */
  public static <T extends U2SAData> Schema<T> of(
      String name, Class<T> messageClass, Supplier<T> empty, MessageType<? super T> parent) {
    return new Schema<>(new MessageType.Identity<>(name, messageClass, empty, false, parent));
  }

  /**
   * Creates the schema of an abstract class.
   *
   * @param carrier creates a placeholder of the class's own type for subclasses unknown to the
   *     reader
   */
  public static <T extends U2SAData> Schema<T> ofAbstract(
      Class<T> messageClass, Supplier<? extends T> carrier, MessageType<? super T> parent) {
    String name = messageClass.getSimpleName();
    return new Schema<>(new MessageType.Identity<>(name, messageClass, carrier, true, parent));
  }

  static Schema<U2SAData> root() {
    return new Schema<>(new MessageType.Identity<>("U2SAData", U2SAData.class, null, true, null));
  }

  static TimestampField<U2SAData> timestamp(Schema<U2SAData> root) {
    return root.added(
        new TimestampField<>(root.outline("timestamp", "us", Presence.OPTIONAL, -1, false)));
  }

  /** Sets the wire format version that introduced the fields declared after this call. */
  public Schema<T> since(int version) {
    since = version;
    return this;
  }

  /** Declares a required name that a superclass gets and sets by field name. */
  public Schema<T> requiring(String field) {
    requiredName(field);
    return this;
  }

  /** Adds an alias of a field for XML, as in the thesis's examples. */
  public void alias(String alias, MessageField<T> field) {
    aliases.put(alias, field.name());
  }

  /** Like {@link #requiring}, for an identifier. */
  public Schema<T> requiringId(String field) {
    requiredId(field);
    return this;
  }

  /** Optional number. */
  public NumberField<T> optionalNumber(String field, String unit) {
    return optionalNumber(field, unit, ANY_LESS);
  }

  /** Optional number of at least {@code min}. */
  public NumberField<T> optionalNumber(String field, String unit, double min) {
    return optionalNumber(field, unit, min, ANY_MORE);
  }

  /** Optional number within bounds. */
  public NumberField<T> optionalNumber(String field, String unit, double min, double max) {
    return number(field, unit, unit, Presence.OPTIONAL, Double.NaN, min, max);
  }

  /**
   * Optional coordinate in metres, or degrees in messages in GLOBAL; up to a million kilometres.
   */
  public NumberField<T> optionalCoordinate(String field) {
    return coordinate(field, Presence.OPTIONAL);
  }

  /** Required coordinate in metres, or degrees in GLOBAL. */
  public NumberField<T> requiredCoordinate(String field) {
    return coordinate(field, Presence.REQUIRED);
  }

  private NumberField<T> coordinate(String field, Presence presence) {
    return number(field, "m", "deg", presence, Double.NaN, -Limits.COORDINATE, Limits.COORDINATE);
  }

  /** Required number within bounds. */
  public NumberField<T> requiredNumber(String field, String unit, double min, double max) {
    return number(field, unit, unit, Presence.REQUIRED, Double.NaN, min, max);
  }

  /** Number with a default. */
  public NumberField<T> number(String field, String unit, double ifUnset) {
    return number(field, unit, ifUnset, ANY_LESS);
  }

  /** Number of at least {@code min} with a default. */
  public NumberField<T> number(String field, String unit, double ifUnset, double min) {
    return number(field, unit, unit, Presence.DEFAULTED, ifUnset, min, ANY_MORE);
  }

  private NumberField<T> number(
      String field,
      String unit,
      String globalUnit,
      Presence presence,
      double ifUnset,
      double min,
      double max) {
    boolean hasBit = presence == Presence.OPTIONAL;
    MessageField.Outline outline = outline(field, unit, presence, slots.number(), hasBit);
    return added(new NumberField<>(outline, globalUnit, ifUnset, min, max));
  }

  /** Required text. */
  public ValueField<T, String> requiredText(String field) {
    return value(field, "", ScalarKinds.TEXT, Presence.REQUIRED, null);
  }

  /** Optional text, without a presence bit. */
  public ValueField<T, String> optionalText(String field) {
    return value(field, "", ScalarKinds.TEXT, Presence.OPTIONAL, null);
  }

  /** Text with a default. */
  public ValueField<T, String> text(String field, String ifUnset) {
    return value(field, "", ScalarKinds.TEXT, Presence.DEFAULTED, ifUnset);
  }

  /** Required name of at most 255 characters. */
  public ValueField<T, String> requiredName(String field) {
    return value(field, "", TextKinds.NAME, Presence.REQUIRED, null);
  }

  /** Optional name, without a presence bit. */
  public ValueField<T, String> optionalName(String field) {
    return value(field, "", TextKinds.NAME, Presence.OPTIONAL, null);
  }

  /** Name with a default. */
  public ValueField<T, String> name(String field, String ifUnset) {
    return value(field, "", TextKinds.NAME, Presence.DEFAULTED, ifUnset);
  }

  /** Required identifier of at most 1,000 characters, because it may contain a name. */
  public ValueField<T, String> requiredId(String field) {
    return value(field, "", TextKinds.ID, Presence.REQUIRED, null);
  }

  /** Optional identifier, without a presence bit. */
  public ValueField<T, String> optionalId(String field) {
    return value(field, "", TextKinds.ID, Presence.OPTIONAL, null);
  }

  /** Identifier with a default. */
  public ValueField<T, String> id(String field, String ifUnset) {
    return value(field, "", TextKinds.ID, Presence.DEFAULTED, ifUnset);
  }

  /**
   * Optional text for people, truncated to 1,000 characters because it may quote other messages;
   * without a presence bit.
   */
  public ValueField<T, String> optionalNote(String field) {
    return value(field, "", TextKinds.NOTE, Presence.OPTIONAL, null);
  }

  /** Text for people, empty by default, truncated to 1,000 characters. */
  public ValueField<T, String> note(String field) {
    return value(field, "", TextKinds.NOTE, Presence.DEFAULTED, "");
  }

  /** List of identifiers, empty by default. */
  public ValueField<T, List<String>> ids(String field) {
    return value(field, "", TextKinds.IDS, Presence.DEFAULTED, List.of());
  }

  /** Optional list of identifiers, without a presence bit. */
  public ValueField<T, List<String>> optionalIds(String field) {
    return value(field, "", TextKinds.IDS, Presence.OPTIONAL, null);
  }

  /** List of texts for people, empty by default, truncated to 100 of 1,000 characters. */
  public ValueField<T, List<String>> notes(String field) {
    return value(field, "", TextKinds.NOTES, Presence.DEFAULTED, List.of());
  }

  /** Optional list of texts for people, truncated to 100 of 1,000 characters. */
  public ValueField<T, List<String>> optionalNotes(String field) {
    return value(field, "", TextKinds.NOTES, Presence.OPTIONAL, null);
  }

  /** Required bytes. */
  public ValueField<T, ByteString> requiredBytes(String field) {
    return value(field, "", ScalarKinds.BYTES, Presence.REQUIRED, null);
  }

  /** Integer, 0 by default. */
  public ValueField<T, Long> count(String field, String unit) {
    return value(field, unit, ScalarKinds.COUNT, Presence.DEFAULTED, 0L);
  }

  /** Optional integer, without a presence bit. */
  public ValueField<T, Long> optionalCount(String field, String unit) {
    return value(field, unit, ScalarKinds.COUNT, Presence.OPTIONAL, null);
  }

  /** Flag, false by default. */
  public ValueField<T, Boolean> flag(String field) {
    return value(field, "", ScalarKinds.FLAG, Presence.DEFAULTED, false);
  }

  /** Optional flag. */
  public ValueField<T, Boolean> optionalFlag(String field) {
    return value(field, "", ScalarKinds.FLAG, Presence.OPTIONAL, null, true);
  }

  /** Optional enum constant. */
  public <E extends Enum<E>> ValueField<T, E> optionalChoice(String field, Class<E> type) {
    return value(field, "", ScalarKinds.choice(type), Presence.OPTIONAL, null, true);
  }

  /**
   * Optional number without a presence bit: for a class with subclasses, whose bits a new one would
   * shift.
   */
  public NumberField<T> optionalNumberWithoutBit(String field, String unit, double min) {
    MessageField.Outline outline = outline(field, unit, Presence.OPTIONAL, slots.number(), false);
    return added(new NumberField<>(outline, unit, Double.NaN, min, ANY_MORE));
  }

  /** Optional flag, without a presence bit. */
  public ValueField<T, Boolean> optionalFlagWithoutBit(String field) {
    return value(field, "", ScalarKinds.FLAG, Presence.OPTIONAL, null);
  }

  /** Optional enum constant, without a presence bit. */
  public <E extends Enum<E>> ValueField<T, E> optionalChoiceWithoutBit(
      String field, Class<E> type) {
    return value(field, "", ScalarKinds.choice(type), Presence.OPTIONAL, null);
  }

  /** Required enum constant. */
  public <E extends Enum<E>> ValueField<T, E> requiredChoice(String field, Class<E> type) {
    return value(field, "", ScalarKinds.choice(type), Presence.REQUIRED, null);
  }

  /** Frame of the message's coordinates. */
  public ValueField<T, ReferenceFrame> frame(String field, ReferenceFrame ifUnset) {
    ValueField<T, ReferenceFrame> frame =
        value(field, "", ScalarKinds.FRAME, Presence.DEFAULTED, ifUnset);
    frameField = frame;
    return frame;
  }

  /** Required point. */
  public ValueField<T, Point> requiredPoint(String field, String unit) {
    return value(field, unit, ScalarKinds.POINT, Presence.REQUIRED, null);
  }

  /** Optional point, without a presence bit. */
  public ValueField<T, Point> optionalPoint(String field, String unit) {
    return value(field, unit, ScalarKinds.POINT, Presence.OPTIONAL, null);
  }

  /** List of points, empty by default. */
  public ValueField<T, List<Point>> points(String field, String unit) {
    return value(field, unit, ListKinds.POINTS, Presence.DEFAULTED, List.of());
  }

  /** List of numbers, empty by default. */
  public ValueField<T, List<Double>> numbers(String field, String unit) {
    return value(field, unit, ListKinds.NUMBERS, Presence.DEFAULTED, List.of());
  }

  /** List of booleans, empty by default. */
  public ValueField<T, List<Boolean>> flags(String field) {
    return value(field, "", ListKinds.FLAGS, Presence.DEFAULTED, List.of());
  }

  /** List of texts, empty by default. */
  public ValueField<T, List<String>> texts(String field) {
    return value(field, "", ListKinds.TEXTS, Presence.DEFAULTED, List.of());
  }

  /** Optional list of texts, without a presence bit. */
  public ValueField<T, List<String>> optionalTexts(String field) {
    return value(field, "", ListKinds.TEXTS, Presence.OPTIONAL, null);
  }

  /** List of messages of one class and its subclasses, empty by default. */
  public <M extends U2SAData> ValueField<T, List<M>> messages(
      String field, MessageType<M> element) {
    ValueKind<List<M>> kind = ListKinds.messages(element.messageClass(), element.name());
    ValueField<T, List<M>> list = value(field, "", kind, Presence.DEFAULTED, List.of());
    elements.put(list, element);
    return list;
  }

  private <V> ValueField<T, V> value(
      String field, String unit, ValueKind<V> kind, Presence presence, V ifUnset) {
    return value(field, unit, kind, presence, ifUnset, false);
  }

  private <V> ValueField<T, V> value(
      String field, String unit, ValueKind<V> kind, Presence presence, V ifUnset, boolean hasBit) {
    MessageField.Outline outline = outline(field, unit, presence, slots.value(), hasBit);
    return added(new ValueField<>(outline, kind, ifUnset));
  }

  private MessageField.Outline outline(
      String field, String unit, Presence presence, int slot, boolean hasBit) {
    int bit = hasBit ? slots.bit() : MessageField.Outline.NO_BIT;
    return new MessageField.Outline(identity.name(), field, unit, presence, slot, bit, since);
  }

  private <F extends MessageField<T>> F added(F field) {
    boolean taken =
        field.name().equals(FieldTable.TYPE_KEY)
            || field.name().equals(Origin.KEY)
            || fields.stream().anyMatch(other -> other.name().equals(field.name()));
    if (taken) {
      throw new IllegalArgumentException(field.path() + ": the name is taken");
    }
    fields.add(field);
    return field;
  }

  /** The finished schema. */
  public MessageType<T> build() {
    return new MessageType<>(
        identity,
        List.copyOf(fields),
        Map.copyOf(aliases),
        Map.copyOf(elements),
        frameField,
        slots.sizes());
  }
}
