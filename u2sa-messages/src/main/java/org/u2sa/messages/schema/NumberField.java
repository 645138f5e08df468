package org.u2sa.messages.schema;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A field that holds a finite double, kept unboxed.
 *
 * @param <T> the message class
 */
public final class NumberField<T extends StoredMessage> extends MessageField<T> {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][+-]?\\d+)?");

  final double ifUnset;
  private final String globalUnit;
  private final double min;
  private final double max;
  final double least; // finite, so that comparisons also reject infinities and NaN
  final double most;

  NumberField(
      MessageField.Outline outline, String globalUnit, double ifUnset, double min, double max) {
    super(outline, Kind.DOUBLE);
    this.globalUnit = globalUnit;
    this.ifUnset = ifUnset;
    this.min = min;
    this.max = max;
    least = min == Double.NEGATIVE_INFINITY ? -Limits.NUMBER : min;
    most = max == Double.POSITIVE_INFINITY ? Limits.NUMBER : max;
  }

  boolean takes(double value) {
    return value >= least && value <= most;
  }

  /** Declared minimum; -∞ if none, and then any practical number is accepted. */
  public double min() {
    return min;
  }

  /** Declared maximum; +∞ if none, and then any practical number is accepted. */
  public double max() {
    return max;
  }

  @Override
  public String unitIn(ReferenceFrame frame) {
    return frame.equals(ReferenceFrame.GLOBAL) ? globalUnit : unit();
  }

  @Override
  public String unitIn(T message) {
    return globalUnit.equals(unit()) ? unit() : unitIn(message.frame());
  }

  double checked(double value) {
    if (takes(value)) {
      return value;
    }
    if (!Double.isFinite(value)) {
      String unit = unit().isEmpty() ? "" : " [" + unit() + "]";
      throw refused(value, "expected a finite number" + unit);
    }
    throw refused(value, "expected " + range(value) + (unit().isEmpty() ? "" : " " + unit()));
  }

  private String range(double value) {
    if (value < least && max == Double.POSITIVE_INFINITY) {
      return "at least " + least;
    }
    return value > most && min == Double.NEGATIVE_INFINITY ? "at most " + most : least + "…" + most;
  }

  /** The value, or the default, or NaN. */
  double in(FieldStorage storage) {
    return storage.number(slot, ifUnset);
  }

  void put(StoredMessage message, double value) {
    double valid = checked(value);
    thawed(message).put(slot, valid);
  }

  @Override
  public Optional<Object> get(T message) {
    boolean hasValue = isSet(message) || !Double.isNaN(ifUnset);
    return hasValue ? Optional.of(in(message.storage)) : Optional.empty();
  }

  @Override
  public boolean isSet(T message) {
    return message.storage.hasNumber(slot);
  }

  @Override
  public void set(T message, Object value) {
    if (!(value instanceof Number number)) {
      throw refused(value, "expected a number");
    }
    put(message, number.doubleValue());
  }

  @Override
  public void setText(T message, String text) {
    String trimmed = text.trim();
    if (!NUMBER.matcher(trimmed).matches()) {
      throw refused(text, "expected a number" + (unit().isEmpty() ? "" : " [" + unit() + "]"));
    }
    put(message, Double.parseDouble(trimmed));
  }

  @Override
  public void setTexts(T message, List<String> texts) {
    if (texts.size() != 1) {
      throw refused(texts, "expected one value");
    }
    setText(message, texts.get(0));
  }

  @Override
  boolean read(CborReader in, T message) throws MalformedMessageException {
    put(message, in.number());
    return true;
  }
}
