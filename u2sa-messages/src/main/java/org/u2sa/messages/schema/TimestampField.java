package org.u2sa.messages.schema;

import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.Limits;

/**
 * Time of measurement [µs]: a field of every message, kept as an unboxed long.
 *
 * @param <T> the message class
 */
final class TimestampField<T extends StoredMessage> extends ValueField<T, Long> {
  TimestampField(MessageField.Outline outline) {
    super(outline, ScalarKinds.COUNT, null);
  }

  @Override
  public boolean isSet(T message) {
    return message.storage.hasTimestamp();
  }

  @Override
  Long valueIn(T message) {
    return isSet(message) ? (Long) message.storage.timestamp() : null;
  }

  @Override
  void put(T message, Long micros) {
    putMicros(message, micros);
  }

  /** Bounds timestamps so that sums, differences and conversion to nanoseconds fit into 64 bits. */
  void putMicros(T message, long micros) {
    if (micros > Limits.TIMESTAMP_MICROS || micros < -Limits.TIMESTAMP_MICROS) {
      throw Limits.expected("a time of at most " + Limits.TIMESTAMP_MICROS + " µs");
    }
    thawed(message).timestamp(micros);
  }

  @Override
  void write(CborOutput out, FieldKey key, T message) {
    if (isSet(message)) {
      out.key(key);
      out.count(message.storage.timestamp());
    }
  }

  @Override
  boolean read(CborReader in, T message) {
    putMicros(message, in.count());
    return true;
  }
}
