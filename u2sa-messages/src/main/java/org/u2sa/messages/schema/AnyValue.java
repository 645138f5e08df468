package org.u2sa.messages.schema;

import com.fasterxml.jackson.dataformat.cbor.CBORGenerator;
import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Map;

/**
 * Values of fields that the reader's classes do not have: Double, Long, Boolean, String, lists and
 * maps of such.
 */
final class AnyValue {
  private AnyValue() {}

  static Object read(CborReader in) throws IOException, MalformedMessageException {
    if (in.token() == null) {
      throw in.unexpected("a value");
    }
    switch (in.token()) {
      case VALUE_NUMBER_FLOAT:
        double number = in.number();
        if (!Double.isFinite(number)) {
          throw in.malformed("expected a finite number, not " + number);
        }
        return number;
      case VALUE_NUMBER_INT:
        return in.count();
      case VALUE_TRUE:
      case VALUE_FALSE:
        return in.flag();
      case VALUE_STRING:
        return in.text();
      case START_ARRAY:
        return Collections.unmodifiableList(in.list(() -> read(in)));
      case START_OBJECT:
        return in.map();
      default:
        throw in.unexpected("a number, text, bool, array or map");
    }
  }

  static void write(CBORGenerator out, Object value) throws IOException {
    if (value instanceof Double number) {
      out.writeNumber(number);
    } else if (value instanceof Long count) {
      out.writeNumber(count);
    } else if (value instanceof Boolean flag) {
      out.writeBoolean(flag);
    } else if (value instanceof List<?> list) {
      out.writeStartArray(null, list.size());
      for (Object element : list) {
        write(out, element);
      }
      out.writeEndArray();
    } else if (value instanceof Map<?, ?> map) {
      out.writeStartObject(null, map.size());
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        out.writeFieldName((String) entry.getKey());
        write(out, entry.getValue());
      }
      out.writeEndObject();
    } else {
      out.writeString((String) value);
    }
  }
}
