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
    return switch (first & Cbor.MAJOR) {
      case Cbor.UNSIGNED, Cbor.NEGATIVE -> in.count();
      case Cbor.TEXT -> in.text();
      case Cbor.BYTES -> in.byteString();
      case Cbor.ARRAY -> Collections.unmodifiableList(in.list(() -> read(in)));
      case Cbor.MAP -> in.map(() -> read(in));
      default -> simple(in, first);
    };
  }

  private static Object simple(CborReader in, int first) throws MalformedMessageException {
    if (first == Cbor.FALSE || first == Cbor.TRUE) {
      return in.flag();
    }
    if (first != Cbor.FLOAT_16 && first != Cbor.FLOAT_32 && first != Cbor.FLOAT_64) {
      throw in.unexpected("a number, text, bool, byte string, array or map");
    }
    double number = in.number();
    if (!Double.isFinite(number)) {
      throw in.malformed("expected a finite number, not " + number);
    }
    return number;
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
