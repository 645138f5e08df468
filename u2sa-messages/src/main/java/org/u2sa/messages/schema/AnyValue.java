package org.u2sa.messages.schema;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.Cbor;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.MalformedMessageException;

/**
 * Values of fields unknown to the reader's classes: Double, Long, Boolean, String, ByteString,
 * lists and maps of these.
 */
final class AnyValue {
  private AnyValue() {}

  static Object read(CborReader in) throws MalformedMessageException {
    List<?> typed = in.typedArray();
    if (typed != null) {
      return typed;
    }
    int first = in.next();
    switch (first & Cbor.MAJOR) {
      case Cbor.UNSIGNED, Cbor.NEGATIVE:
        return in.count();
      case Cbor.TEXT:
        return in.text();
      case Cbor.BYTES:
        return in.byteString();
      case Cbor.ARRAY:
        return Collections.unmodifiableList(in.list(() -> read(in)));
      case Cbor.MAP:
        return in.map(() -> read(in));
      default:
        return simple(in, first);
    }
  }

  private static Object simple(CborReader in, int first) throws MalformedMessageException {
    switch (first) {
      case Cbor.FALSE, Cbor.TRUE:
        return in.flag();
      case Cbor.FLOAT_16, Cbor.FLOAT_32, Cbor.FLOAT_64:
        double number = in.number();
        if (!Double.isFinite(number)) {
          throw in.malformed("expected a finite number, not " + number);
        }
        return number;
      default:
        throw in.unexpected("a number, text, bool, byte string, array or map");
    }
  }

  static void write(CborOutput out, Object value) {
    if (value instanceof Double number) {
      out.number(number);
    } else if (value instanceof Long count) {
      out.count(count);
    } else if (value instanceof Boolean flag) {
      out.flag(flag);
    } else if (value instanceof ByteString bytes) {
      out.byteString(bytes);
    } else if (value instanceof List<?> list) {
      out.array(list.size());
      for (Object element : list) {
        write(out, element);
      }
    } else if (value instanceof Map<?, ?> map) {
      out.map(map.size());
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        out.key(out.form().key((String) entry.getKey()));
        write(out, entry.getValue());
      }
    } else {
      out.text((String) value);
    }
  }
}
