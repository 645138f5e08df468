package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Declares the fields of one message class, a line each, in wire order; used in the class's static
 * initialiser and nowhere else. Append new fields at the end, after a call of {@link #since}.
 *
 * <pre>{@code
 * private static final Schema<Beacon> SCHEMA = Schema.of(Beacon.class, Beacon::new, ObjectDescription.TYPE);
 * private static final NumberField<Beacon> RANGE = SCHEMA.optionalNumber("range", "m");
 * public static final MessageType<Beacon> TYPE = SCHEMA.build();
 * }</pre>
 *
 * <p>An optional number, flag or enum gets the next bit of the presence vector. Optional texts need
 * none: they are absent or not.
 *
 * @param <T> the message class
 */
public final class Schema<T extends U2SAData> {
  static final String TYPE_KEY = "type";
  private static final double ANY_LESS = Double.NEGATIVE_INFINITY;
  private static final double ANY_MORE = Double.POSITIVE_INFINITY;

  private final MessageType.Identity<T> identity;
  private final List<MessageField<T>> fields = new ArrayList<>();
  private final Map<String, String> aliases = new HashMap<>();
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
    slots = FieldSlots.after(parent.sizes());
    for (MessageField<? super T> field : parent.fields()) {
      fields.add(MessageType.inherited(field));
    }
    aliases.putAll(parent.aliases());
    frameField = parent.frameField();
  }

  /**
   * The schema of a class that can be made; topics and XML call it by its simple name.
   *
   * @param empty makes a message with nothing set
   */
  public static <T extends U2SAData> Schema<T> of(
      Class<T> messageClass, Supplier<T> empty, MessageType<? super T> parent) {
    return of(messageClass.getSimpleName(), messageClass, empty, parent);
  }

  /** The same under another name, as of a class that stands for one of another program. */
  public static <T extends U2SAData> Schema<T> of(
      String name, Class<T> messageClass, Supplier<T> empty, MessageType<? super T> parent) {
    return new Schema<>(new MessageType.Identity<>(name, messageClass, empty, false, parent));
  }

  /**
   * The schema of an abstract class.
   *
   * @param carrier makes a message of the class's own type that stands for subclasses which the
   *     reader does not know
   */
  public static <T extends U2SAData> Schema<T> ofAbstract(
      Class<T> messageClass, Supplier<? extends T> carrier, MessageType<? super T> parent) {
    String name = messageClass.getSimpleName();
    return new Schema<>(new MessageType.Identity<>(name, messageClass, carrier, true, parent));
  }

  static Schema<U2SAData> root() {
    return new Schema<>(new MessageType.Identity<>("U2SAData", U2SAData.class, null, true, null));
  }

  static TimestampField timestamp(Schema<U2SAData> root) {
    return root.added(new TimestampField(root.outline("timestamp", "us", FieldPresence.OPTIONAL)));
  }

  /** Fields declared after this call joined the wire format in the given version. */
  public Schema<T> since(int version) {
    since = version;
    return this;
  }

  /** Declares a name that is required, and that a superclass gets and sets by its name. */
  public Schema<T> requiring(String field) {
    requiredName(field);
    return this;
  }

  /** Lets XML call a field by another name too, as the thesis's examples do. */
  public void alias(String alias, MessageField<T> field) {
    aliases.put(alias, field.name());
  }

  /** As {@link #requiring}, but an identifier. */
  public Schema<T> requiringId(String field) {
    requiredId(field);
    return this;
  }

  /** A number that may be absent. */
  public NumberField<T> optionalNumber(String field, String unit) {
    return optionalNumber(field, unit, ANY_LESS);
  }

  /** A number that may be absent and is never less than {@code min}. */
  public NumberField<T> optionalNumber(String field, String unit, double min) {
    return optionalNumber(field, unit, min, ANY_MORE);
  }

  /** A number that may be absent, within bounds. */
  public NumberField<T> optionalNumber(String field, String unit, double min, double max) {
    return number(outline(field, unit, FieldPresence.OPTIONAL), unit, Double.NaN, min, max);
  }

  /**
   * A coordinate that may be absent: in metres, but in degrees in messages that are written in
   * GLOBAL; at most a million kilometres.
   */
  public NumberField<T> optionalCoordinate(String field) {
    FieldOutline outline = outline(field, "m", FieldPresence.OPTIONAL);
    return number(outline, "deg", Double.NaN, -Limits.COORDINATE, Limits.COORDINATE);
  }

  /** A coordinate without which no message is published: in metres, in GLOBAL in degrees. */
  public NumberField<T> requiredCoordinate(String field) {
    FieldOutline outline = outline(field, "m", FieldPresence.REQUIRED);
    return number(outline, "deg", Double.NaN, -Limits.COORDINATE, Limits.COORDINATE);
  }

  /** A number without which no message is published, within bounds. */
  public NumberField<T> requiredNumber(String field, String unit, double min, double max) {
    return number(outline(field, unit, FieldPresence.REQUIRED), unit, Double.NaN, min, max);
  }

  /** A number that has a value from the start. */
  public NumberField<T> number(String field, String unit, double ifUnset) {
    return number(field, unit, ifUnset, ANY_LESS);
  }

  /** A number that has a value from the start and is never less than {@code min}. */
  public NumberField<T> number(String field, String unit, double ifUnset, double min) {
    return number(outline(field, unit, FieldPresence.DEFAULTED), unit, ifUnset, min, ANY_MORE);
  }

  private NumberField<T> number(
      FieldOutline outline, String globalUnit, double ifUnset, double min, double max) {
    FieldOutline placed = outline.at(slots.number());
    if (outline.presence() == FieldPresence.OPTIONAL) {
      placed = placed.withBit(slots.bit());
    }
    return added(new NumberField<>(placed, globalUnit, ifUnset, min, max));
  }

  /** A text without which no message is published. */
  public ValueField<T, String> requiredText(String field) {
    return value(field, "", ScalarKinds.TEXT, FieldPresence.REQUIRED, null, false);
  }

  /** A text that may be absent. It has no bit in the presence vector. */
  public ValueField<T, String> optionalText(String field) {
    return value(field, "", ScalarKinds.TEXT, FieldPresence.OPTIONAL, null, false);
  }

  /** A text that has a value from the start. */
  public ValueField<T, String> text(String field, String ifUnset) {
    return value(field, "", ScalarKinds.TEXT, FieldPresence.DEFAULTED, ifUnset, false);
  }

  /** A name without which no message is published. Names beyond 255 characters are refused. */
  public ValueField<T, String> requiredName(String field) {
    return value(field, "", TextKinds.NAME, FieldPresence.REQUIRED, null, false);
  }

  /** A name that may be absent. It has no bit in the presence vector. */
  public ValueField<T, String> optionalName(String field) {
    return value(field, "", TextKinds.NAME, FieldPresence.OPTIONAL, null, false);
  }

  /** A name that has a value from the start. */
  public ValueField<T, String> name(String field, String ifUnset) {
    return value(field, "", TextKinds.NAME, FieldPresence.DEFAULTED, ifUnset, false);
  }

  /**
   * An identifier without which no message is published: of up to 1,000 characters, as it may be
   * made of a name.
   */
  public ValueField<T, String> requiredId(String field) {
    return value(field, "", TextKinds.ID, FieldPresence.REQUIRED, null, false);
  }

  /** An identifier that may be absent. It has no bit in the presence vector. */
  public ValueField<T, String> optionalId(String field) {
    return value(field, "", TextKinds.ID, FieldPresence.OPTIONAL, null, false);
  }

  /** An identifier that has a value from the start. */
  public ValueField<T, String> id(String field, String ifUnset) {
    return value(field, "", TextKinds.ID, FieldPresence.DEFAULTED, ifUnset, false);
  }

  /**
   * Text for people that may be absent, shortened to 1,000 characters: for whatever is composed of
   * the content of other messages. It has no bit in the presence vector.
   */
  public ValueField<T, String> optionalNote(String field) {
    return value(field, "", TextKinds.NOTE, FieldPresence.OPTIONAL, null, false);
  }

  /** Text for people that is empty from the start, shortened to 1,000 characters. */
  public ValueField<T, String> note(String field) {
    return value(field, "", TextKinds.NOTE, FieldPresence.DEFAULTED, "", false);
  }

  /** A list of identifiers, empty from the start. */
  public ValueField<T, List<String>> ids(String field) {
    return value(field, "", ListKinds.IDS, FieldPresence.DEFAULTED, List.of(), false);
  }

  /** A list of identifiers that may be absent. It has no bit in the presence vector. */
  public ValueField<T, List<String>> optionalIds(String field) {
    return value(field, "", ListKinds.IDS, FieldPresence.OPTIONAL, null, false);
  }

  /** Texts for people, shortened to 100 of 1,000 characters; empty from the start. */
  public ValueField<T, List<String>> notes(String field) {
    return value(field, "", TextKinds.NOTES, FieldPresence.DEFAULTED, List.of(), false);
  }

  /** Texts for people that may be absent, shortened to 100 of 1,000 characters. */
  public ValueField<T, List<String>> optionalNotes(String field) {
    return value(field, "", TextKinds.NOTES, FieldPresence.OPTIONAL, null, false);
  }

  /** Bytes without which no message is published. */
  public ValueField<T, ByteString> requiredBytes(String field) {
    return value(field, "", ScalarKinds.BYTES, FieldPresence.REQUIRED, null, false);
  }

  /** A whole number, 0 from the start. */
  public ValueField<T, Long> count(String field, String unit) {
    return value(field, unit, ScalarKinds.COUNT, FieldPresence.DEFAULTED, 0L, false);
  }

  /** A whole number that may be absent. It has no bit in the presence vector. */
  public ValueField<T, Long> optionalCount(String field, String unit) {
    return value(field, unit, ScalarKinds.COUNT, FieldPresence.OPTIONAL, null, false);
  }

  /** True or false, false from the start. */
  public ValueField<T, Boolean> flag(String field) {
    return value(field, "", ScalarKinds.FLAG, FieldPresence.DEFAULTED, false, false);
  }

  /** True, false or absent. */
  public ValueField<T, Boolean> optionalFlag(String field) {
    return value(field, "", ScalarKinds.FLAG, FieldPresence.OPTIONAL, null, true);
  }

  /** One of an enum's constants; may be absent. */
  public <E extends Enum<E>> ValueField<T, E> optionalChoice(String field, Class<E> type) {
    return value(field, "", ScalarKinds.choice(type), FieldPresence.OPTIONAL, null, true);
  }

  /**
   * A number that may be absent and has no bit in the presence vector: for a class that has
   * subclasses, whose bits a further one would move.
   */
  public NumberField<T> optionalNumberWithoutBit(String field, String unit, double min) {
    FieldOutline outline = outline(field, unit, FieldPresence.OPTIONAL).at(slots.number());
    return added(new NumberField<>(outline, unit, Double.NaN, min, ANY_MORE));
  }

  /** One of an enum's constants; may be absent, without a bit in the presence vector. */
  public <E extends Enum<E>> ValueField<T, E> optionalChoiceWithoutBit(
      String field, Class<E> type) {
    return value(field, "", ScalarKinds.choice(type), FieldPresence.OPTIONAL, null, false);
  }

  /** One of an enum's constants, without which no message is published. */
  public <E extends Enum<E>> ValueField<T, E> requiredChoice(String field, Class<E> type) {
    return value(field, "", ScalarKinds.choice(type), FieldPresence.REQUIRED, null, false);
  }

  /** The frame that the message's coordinates are written in. */
  public ValueField<T, ReferenceFrame> frame(String field, ReferenceFrame ifUnset) {
    ValueField<T, ReferenceFrame> frame =
        value(field, "", ScalarKinds.FRAME, FieldPresence.DEFAULTED, ifUnset, false);
    frameField = frame;
    return frame;
  }

  /** A point without which no message is published. */
  public ValueField<T, Point> requiredPoint(String field, String unit) {
    return value(field, unit, ScalarKinds.POINT, FieldPresence.REQUIRED, null, false);
  }

  /** A point that may be absent. It has no bit in the presence vector. */
  public ValueField<T, Point> optionalPoint(String field, String unit) {
    return value(field, unit, ScalarKinds.POINT, FieldPresence.OPTIONAL, null, false);
  }

  /** A list of points, empty from the start. */
  public ValueField<T, List<Point>> points(String field, String unit) {
    return value(field, unit, ListKinds.POINTS, FieldPresence.DEFAULTED, List.of(), false);
  }

  /** A list of numbers, empty from the start. */
  public ValueField<T, List<Double>> numbers(String field, String unit) {
    return value(field, unit, ListKinds.NUMBERS, FieldPresence.DEFAULTED, List.of(), false);
  }

  /** A list of true or false, empty from the start. */
  public ValueField<T, List<Boolean>> flags(String field) {
    return value(field, "", ListKinds.FLAGS, FieldPresence.DEFAULTED, List.of(), false);
  }

  /** A list of texts, empty from the start. */
  public ValueField<T, List<String>> texts(String field) {
    return value(field, "", ListKinds.TEXTS, FieldPresence.DEFAULTED, List.of(), false);
  }

  /** A list of texts that may be absent. It has no bit in the presence vector. */
  public ValueField<T, List<String>> optionalTexts(String field) {
    return value(field, "", ListKinds.TEXTS, FieldPresence.OPTIONAL, null, false);
  }

  /** A list of messages of one class and its subclasses, empty from the start. */
  public <M extends U2SAData> ValueField<T, List<M>> messages(
      String field, MessageType<M> element) {
    ValueKind<List<M>> kind = ListKinds.messages(element);
    return value(field, "", kind, FieldPresence.DEFAULTED, List.of(), false);
  }

  private <V> ValueField<T, V> value(
      String field,
      String unit,
      ValueKind<V> kind,
      FieldPresence presence,
      V ifUnset,
      boolean hasBit) {
    FieldOutline outline = outline(field, unit, presence).at(slots.value());
    FieldOutline placed = hasBit ? outline.withBit(slots.bit()) : outline;
    return added(new ValueField<>(placed, kind, ifUnset));
  }

  private FieldOutline outline(String field, String unit, FieldPresence presence) {
    return FieldOutline.of(identity.name(), field, unit, presence, since);
  }

  private <F extends MessageField<T>> F added(F field) {
    boolean taken =
        field.name().equals(TYPE_KEY)
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
        identity, List.copyOf(fields), Map.copyOf(aliases), frameField, slots.sizes());
  }
}
