package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Base class of all messages (thesis 3.2.3.1, figure 5), with system, timestamp, field access and
 * serialisation.
 *
 * <p>Filled by setters, then frozen by the publisher, and thread-safe from then on. A subclass
 * declares its fields in a {@link Schema} and writes getters and setters over {@link #get}, {@link
 * #require} and {@link #put}. A field's getter and setter share its name: the getter's Javadoc
 * states meaning, unit and range, and the setter rejects values beyond it.
 */
public abstract class U2SAData extends StoredMessage {
  private static final Schema<U2SAData> SCHEMA = Schema.root();
  private static final ValueField<U2SAData, String> SYSTEM_ID = SCHEMA.optionalName("systemId");
  private static final TimestampField<U2SAData> TIMESTAMP = Schema.timestamp(SCHEMA);

  /** The root of all types: systemId and timestamp. */
  public static final MessageType<U2SAData> TYPE = SCHEMA.build();

  private static final int SHOWN_CHARS = 1_000; // of a value in toString

  private UnknownPart unknown; // fields of the unknown subclass in placeholders; else null
  private Origin origin; // of messages received over MQTT; else null
  private int receivedBytes; // memory of decoded messages; else 0

  /** Creates an empty message of the type {@link #type()}. */
  protected U2SAData() {}

  /** The class's schema: its constant TYPE. Called while the message is constructed. */
  public abstract MessageType<?> type();

  /** Names from the topmost ancestor to the message's own type, even if unknown to this reader. */
  @Override
  public final List<String> typeChain() {
    return unknown == null ? type().chain() : unknown.chain();
  }

  /** System that the message comes from; empty until set. */
  public final String systemId() {
    String id = get(SYSTEM_ID);
    return id == null ? "" : id;
  }

  public final void systemId(String id) {
    put(SYSTEM_ID, id);
  }

  /** Time of measurement [µs of the run's clock]; empty until set. */
  public final OptionalLong timestamp() {
    return storage.hasTimestamp() ? OptionalLong.of(storage.timestamp()) : OptionalLong.empty();
  }

  /**
   * Sets {@link #timestamp()}.
   *
   * @throws IllegalArgumentException beyond the year 2262
   */
  public final void timestamp(long micros) {
    TIMESTAMP.putMicros(this, micros);
  }

  /**
   * Presence bits of the optional numbers, points and enums, in schema order from bit 0 (8.2.3.2).
   */
  public long presenceVector() {
    long vector = 0L;
    for (MessageField<U2SAData> field : fields()) {
      if (field.bit != MessageField.Outline.NO_BIT && field.isSet(this)) {
        vector |= 1L << field.bit;
      }
    }
    return vector;
  }

  /**
   * Encodes the message as a CBOR map, as specified in docs/wire-protocol.md (thesis 3.2.3.1).
   *
   * @throws IllegalStateException if a required field is missing or the bytes exceed 1 MiB
   */
  public final byte[] serialize() {
    return bytes(null, WireForm.READABLE);
  }

  /** Encodes the message, with its sender unless null. */
  final byte[] bytes(Origin sentFrom, WireForm form) {
    requireComplete();
    return CborWriter.bytes(this, ownType().table(form), sentFrom, form);
  }

  @Override
  final void writeNested(CborOutput out) {
    CborWriter.nested(out, this, ownType().table(out.form()));
  }

  /** Sender of the bytes it was decoded from; empty if unknown or not decoded. */
  public final Optional<Origin> origin() {
    return Optional.ofNullable(origin);
  }

  /**
   * Approximate memory use [B], at least the size of the encoded form; 0 if created in this
   * process. For budgets: a packed list of points takes seven times its bytes.
   */
  public final int receivedBytes() {
    return receivedBytes;
  }

  /** All fields with unit and value, in wire order; absent values are empty (thesis 3.2.3.1). */
  public final List<FieldValue> enumerateFields() {
    List<FieldValue> all = new ArrayList<>();
    for (MessageField<U2SAData> field : fields()) {
      all.add(new FieldValue(field.name(), field.unitIn(this), field.get(this)));
    }
    unknownFields().forEach((name, value) -> all.add(new FieldValue(name, "", Optional.of(value))));
    return Collections.unmodifiableList(all);
  }

  /**
   * Makes this message and nested ones immutable; called by the publisher.
   *
   * @throws IllegalStateException naming the missing required field, or the inconsistency
   */
  public final void freeze() {
    if (!storage.isFrozen()) {
      requireComplete();
      for (int slot : type().messageLists) {
        storage.list(slot).forEach(nested -> ((U2SAData) nested).freeze());
      }
      storage.freeze();
    }
  }

  /** Whether the message is frozen, so that setters throw. */
  public final boolean isFrozen() {
    return storage.isFrozen();
  }

  /** Unfrozen copy. */
  public U2SAData copy() {
    U2SAData copy = type().newCarrier();
    copy.storage.takeFrom(storage);
    for (int slot : type().messageLists) {
      if (storage.value(slot) != null) {
        copy.storage.put(slot, copies(storage.list(slot)));
      }
    }
    copy.unknown = unknown;
    return copy;
  }

  private static List<U2SAData> copies(List<?> messages) {
    List<U2SAData> copies = new ArrayList<>(messages.size());
    for (Object message : messages) {
      copies.add(((U2SAData) message).copy());
    }
    return List.copyOf(copies);
  }

  /**
   * Checks consistency beyond single fields' bounds: whether fields agree, whether packed content
   * can be unpacked. Called before a message is frozen, encoded or delivered, so that receivers
   * never see an inconsistent one.
   *
   * @throws IllegalStateException naming the field and the error
   */
  protected void requireConsistent() {}

  /**
   * @throws IllegalStateException naming the missing required field, or the inconsistency
   */
  void requireComplete() {
    if (storage.isFrozen()) {
      return; // checked when frozen
    }
    MessageField<U2SAData> missing = ownType().table().missing(this);
    if (missing != null) {
      throw missing(missing);
    }
    requireConsistent();
  }

  /** The value of a number; empty if it is absent and has no default. */
  protected final OptionalDouble get(NumberField<?> field) {
    double value = field.in(storage);
    return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /**
   * The value of a number that is required or has a default.
   *
   * @throws IllegalStateException if it was never set
   */
  protected final double require(NumberField<?> field) {
    double value = field.in(storage);
    if (Double.isNaN(value)) {
      throw missing(field);
    }
    return value;
  }

  /** The value of an integer; empty if it is absent and has no default. */
  protected final OptionalLong optionalCount(ValueField<?, Long> field) {
    Long value = field.in(storage);
    return value == null ? OptionalLong.empty() : OptionalLong.of(value);
  }

  /** The value, or its default; null if it has neither. */
  protected final <V> V get(ValueField<?, V> field) {
    return field.in(storage);
  }

  /**
   * The value of a field that is required or has a default.
   *
   * @throws IllegalStateException if it was never set
   */
  protected final <V> V require(ValueField<?, V> field) {
    V value = field.in(storage);
    if (value == null) {
      throw missing(field);
    }
    return value;
  }

  /**
   * Sets a number; returns this message.
   *
   * @throws IllegalArgumentException if not finite or out of range
   * @throws IllegalStateException if frozen
   */
  protected final <T extends U2SAData> T put(NumberField<T> field, double value) {
    field.put(this, value);
    return self();
  }

  /**
   * Sets a value; returns this message.
   *
   * @throws IllegalArgumentException if null, too long or otherwise out of bounds
   * @throws IllegalStateException if frozen
   */
  protected final <T extends U2SAData, V> T put(ValueField<T, V> field, V value) {
    V valid = field.checked(value);
    field.thawed(this).put(field.slot, valid);
    return self();
  }

  @SuppressWarnings("unchecked") // fields are set on messages of the declaring class
  private <T extends U2SAData> T self() {
    return (T) this;
  }

  private static IllegalStateException missing(MessageField<?> field) {
    return new IllegalStateException(field.path() + " is required and was never set");
  }

  @Override
  final int valueSlots() {
    return type().sizes.values();
  }

  @Override
  final ReferenceFrame frame() {
    ValueField<?, ReferenceFrame> field = type().frameField;
    return field == null ? ReferenceFrame.BODY : field.in(storage);
  }

  final void cameFrom(Origin sentFrom) {
    origin = sentFrom;
  }

  final void decodedFrom(int bytes) {
    receivedBytes = bytes;
  }

  final void keepUnknown(UnknownPart part) {
    unknown = part;
  }

  @Override
  final Map<String, Object> unknownFields() {
    return unknown == null ? Map.of() : unknown.fields();
  }

  /** {@link #type()}, typed for iterating over the fields of any message. */
  @SuppressWarnings("unchecked") // a message is an instance of its type's class
  protected final MessageType<U2SAData> ownType() {
    return (MessageType<U2SAData>) type();
  }

  private List<MessageField<U2SAData>> fields() {
    return ownType().fields();
  }

  @Override
  public final boolean equals(Object other) {
    return this == other
        || other instanceof U2SAData that
            && typeChain().equals(that.typeChain())
            && enumerateFields().equals(that.enumerateFields());
  }

  @Override
  public final int hashCode() {
    return 31 * typeChain().hashCode() + enumerateFields().hashCode();
  }

  /** "Waypoint{uid=1, x=10.0 deg}": set fields, each value truncated to 1,000 characters. */
  @Override
  public final String toString() {
    List<String> parts = new ArrayList<>();
    for (FieldValue field : enumerateFields()) {
      if (field.value().isPresent()) {
        String unit = field.unit().isEmpty() ? "" : " " + field.unit();
        parts.add(field.name() + "=" + shown(field.value().get()) + unit);
      }
    }
    List<String> chain = typeChain();
    return chain.get(chain.size() - 1) + "{" + String.join(", ", parts) + "}";
  }

  private static String shown(Object value) {
    String text = String.valueOf(value);
    return text.length() <= SHOWN_CHARS ? text : text.substring(0, SHOWN_CHARS) + "…";
  }

  /**
   * Parts of a message unknown to the reader's classes.
   *
   * @param chain the message's own type chain
   * @param fields fields beyond the known ancestor's, as read
   */
  record UnknownPart(List<String> chain, Map<String, Object> fields) {}
}
