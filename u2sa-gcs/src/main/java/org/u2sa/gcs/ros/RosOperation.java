package org.u2sa.gcs.ros;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.report.message.JsonReader;

/** One operation of a client, with checked access to its fields. */
record RosOperation(Map<String, Object> fields) {
  private static final int LONGEST_NAME = 256;
  private static final int MAX_VALUES = 2_000; // a change of 256 variables needs 770
  private static final long MAX_COUNT = 3_600_000; // ms of an hour

  /**
   * @throws BadInputException if it is not a JSON object with a text "op", or has too many values
   */
  static RosOperation parse(String text) {
    RosOperation operation = new RosOperation(JsonReader.object("operation", text, MAX_VALUES));
    operation.text("op");
    return operation;
  }

  String name() {
    return text("op");
  }

  String topic() {
    return text("topic");
  }

  boolean has(String name) {
    Object value = fields.get(name);
    return value != null && !(value instanceof Optional); // null counts as absent
  }

  /** A short string. */
  String text(String name) {
    Object value = fields.get(name);
    if (value instanceof String text && !text.isEmpty() && text.length() <= LONGEST_NAME) {
      return text;
    }
    throw new BadInputException(
        "\"" + name + "\": expected a text of 1…" + LONGEST_NAME + " characters");
  }

  String optionalText(String name) {
    return has(name) && !"".equals(fields.get(name)) ? text(name) : "";
  }

  /** The client's ID of the operation. */
  String idOr(String otherwise) {
    return has("id") ? text("id") : otherwise;
  }

  /** A whole number of at least 0; 0 if absent. */
  long count(String name) {
    if (!has(name)) {
      return 0;
    }
    if (fields.get(name) instanceof Number number
        && number.doubleValue() >= 0
        && number.doubleValue() <= MAX_COUNT) {
      return number.longValue();
    }
    throw new BadInputException("\"" + name + "\": expected 0…" + MAX_COUNT);
  }

  /** An object; empty if absent, or an empty list. */
  @SuppressWarnings("unchecked") // JsonReader creates maps with text keys only
  Map<String, Object> object(String name) {
    Object value = fields.get(name);
    if (!has(name) || value instanceof List<?> list && list.isEmpty()) {
      return Map.of();
    }
    if (value instanceof Map<?, ?> map) {
      return (Map<String, Object>) map;
    }
    throw new BadInputException("\"" + name + "\": expected an object");
  }
}
