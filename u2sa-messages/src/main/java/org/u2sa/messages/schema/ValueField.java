package org.u2sa.messages.schema;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A field of any kind except double.
 *
 * @param <T> the message class
 * @param <V> the value's class; immutable
 */
public class ValueField<T extends StoredMessage, V> extends MessageField<T> {
  final V ifUnset; // null: none
  private final ValueKind<V> values;
  private final int longest; // length up to which any text is within bounds

  ValueField(MessageField.Outline outline, ValueKind<V> values, V ifUnset) {
    super(outline, values.kind());
    this.values = values;
    this.ifUnset = ifUnset;
    longest = values.longest();
  }

  /** For an enum, its constants in wire order; else empty. */
  public final List<V> constants() {
    return values.constants();
  }

  /**
   * Maximum length of a text, or of each in a list [characters]; empty if only its bytes are
   * bounded.
   */
  public final OptionalInt maxLength() {
    return longest == Integer.MAX_VALUE ? OptionalInt.empty() : OptionalInt.of(longest);
  }

  /** Whether longer texts are truncated to {@link #maxLength} instead of rejected. */
  public final boolean shortens() {
    return values.shortens();
  }

  final V checked(Object value) {
    try {
      return values.checked(value);
    } catch (IllegalArgumentException e) {
      throw refused(value, e.getMessage());
    }
  }

  /** The value, or its default; null if it has neither. */
  @SuppressWarnings("unchecked") // only this field fills the slot
  final V in(FieldStorage storage) {
    Object value = storage.value(slot);
    return value == null ? ifUnset : (V) value;
  }

  /** Like {@link #in}, wherever the field's values are stored. */
  V valueIn(T message) {
    return in(message.storage);
  }

  void put(T message, V value) {
    thawed(message).put(slot, value);
  }

  @Override
  public final Optional<Object> get(T message) {
    return Optional.ofNullable(valueIn(message));
  }

  @Override
  public boolean isSet(T message) {
    return message.storage.value(slot) != null;
  }

  @Override
  public final void set(T message, Object value) {
    put(message, checked(value));
  }

  @Override
  public final void setText(T message, String text) {
    setTexts(message, List.of(text));
  }

  @Override
  public final void setTexts(T message, List<String> texts) {
    V value;
    try {
      value = values.parsed(texts);
    } catch (IllegalArgumentException e) {
      throw refused(texts.size() == 1 ? texts.get(0) : texts, e.getMessage());
    }
    set(message, value);
  }

  /** Writes key and value if the field is set or has a default. */
  void write(CborOutput out, FieldKey key, T message) {
    V value = valueIn(message);
    if (value != null) {
      out.key(key);
      if (value instanceof String text) { // fast path for the most common kind
        out.text(text);
      } else if (value instanceof ReferenceFrame frame) {
        out.text(frame.name());
      } else {
        values.write(out, value);
      }
    }
  }

  @Override
  boolean read(CborReader in, T message) throws MalformedMessageException {
    V value;
    try {
      value = kind() == Kind.STRING ? text(in) : values.readChecked(in);
    } catch (ValueKind.UnknownConstantException e) {
      if (!isOptional()) {
        throw e;
      }
      return false; // treated as absent, because its meaning is unknown to this reader
    }
    put(message, value);
    return true;
  }

  @SuppressWarnings("unchecked") // a field of that kind holds texts
  private V text(CborReader in) { // fast path for the most common kind
    String text = in.text();
    return text.length() <= longest ? (V) text : values.checked(text);
  }
}
