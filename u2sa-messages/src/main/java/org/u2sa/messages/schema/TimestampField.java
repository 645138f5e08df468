package org.u2sa.messages.schema;

import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.Limits;

/** Time of measurement [µs]: a field of every message, kept as an unboxed long. */
final class TimestampField extends ValueField<U2SAData, Long> {
  TimestampField(FieldOutline outline) {
    super(outline, ScalarKinds.COUNT, null);
  }

  @Override
  public boolean isSet(U2SAData message) {
    return message.storage().hasTimestamp();
  }

  @Override
  Long valueIn(U2SAData message) {
    return isSet(message) ? (Long) message.storage().timestamp() : null;
  }

  @Override
  void put(U2SAData message, Long micros) {
    message.storage().timestamp(this, within(micros));
  }

  /** Bounds timestamps so that sums, differences and conversion to nanoseconds fit into 64 bits. */
  static long within(long micros) {
    if (micros > Limits.TIMESTAMP_MICROS || micros < -Limits.TIMESTAMP_MICROS) {
      throw Limits.expected("a time of at most " + Limits.TIMESTAMP_MICROS + " µs");
    }
    return micros;
  }

  @Override
  void write(CborOutput out, FieldKey key, U2SAData message) {
    if (isSet(message)) {
      out.key(key);
      out.count(message.storage().timestamp());
    }
  }

  @Override
  boolean read(CborReader in, U2SAData message) {
    message.storage().timestamp(this, within(in.count()));
    return true;
  }
}
