package org.u2sa.report.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.units.NumberWithUnit;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/**
 * Creates messages from JSON objects, validated by their type's schema. A number may be a text with
 * a unit, {@code "90 deg"}, which is converted to the field's unit.
 */
public final class MessageFromJson {
  private static final String TYPE = "type";

  private final MessageTypes types;

  /** Supports these types. */
  public MessageFromJson(MessageTypes types) {
    this.types = types;
  }

  /**
   * Creates a message that its readers accept, with all required fields set.
   *
   * @param origin description of the JSON, for errors
   * @throws BadInputException naming the field that is unknown, missing, of the wrong kind or unit,
   *     out of range, or inconsistent with others
   */
  public U2SAData message(String origin, MessageType<?> type, Map<String, Object> json) {
    if (type.isAbstract()) {
      throw new BadInputException(
          origin + ": " + type.name() + " is abstract: expected a subclass as \"type\"");
    }
    U2SAData message = filled(origin, type, json);
    try {
      MessageCodec codec = new MessageCodec(types);
      codec.decode(message.typeChain(), codec.encode(message));
    } catch (MalformedMessageException e) {
      throw new BadInputException(origin + ": " + type.name() + ", " + e.reason(), e);
    } catch (IllegalStateException e) {
      throw new BadInputException(origin + ": " + e.getMessage(), e);
    }
    return message;
  }

  private <T extends U2SAData> T filled(
      String origin, MessageType<T> type, Map<String, Object> json) {
    T message = type.create();
    for (Kind kind : List.of(Kind.FRAME, Kind.ENUM)) { // units of coordinates depend on the frame
      setAll(origin, type, json, message, kind, true);
    }
    setAll(origin, type, json, message, Kind.FRAME, false);
    for (MessageField<T> field : type.fields()) {
      if (field.isRequired() && !field.isSet(message)) {
        throw new BadInputException(
            origin + ": field \"" + field.name() + "\" of " + type.name() + " is required");
      }
    }
    return message;
  }

  private <T extends U2SAData> void setAll(
      String origin,
      MessageType<T> type,
      Map<String, Object> json,
      T message,
      Kind kind,
      boolean only) {
    json.forEach(
        (name, value) -> {
          if (name.equals(TYPE) && type.field(TYPE).isEmpty()) {
            return;
          }
          MessageField<T> field = type.field(name).orElseThrow(() -> unknown(origin, type, name));
          if (only == (field.kind() == kind)) {
            set(origin, field, message, value);
          }
        });
  }

  private static BadInputException unknown(String origin, MessageType<?> type, String name) {
    List<String> names =
        type.fields().stream().map(MessageField::name).collect(Collectors.toList());
    return new BadInputException(
        String.format(
            "%s: %s has no field \"%s\"%s; it has %s",
            origin,
            type.name(),
            name,
            NearestNames.didYouMean(name, names),
            String.join(", ", names)));
  }

  private <T extends U2SAData> void set(
      String origin, MessageField<T> field, T message, Object value) {
    String at = origin + ": field \"" + field.name() + "\"";
    try {
      switch (field.kind()) {
        case DOUBLE -> field.set(message, number(at, field.unitIn(message), value));
        case LONG -> field.set(message, as(Long.class, at, "a whole number", value));
        case BOOLEAN -> field.set(message, as(Boolean.class, at, "true or false", value));
        case STRING -> field.set(message, as(String.class, at, "a text", value));
        case BYTES -> field.setText(message, as(String.class, at, "a base64 text", value));
        case ENUM, FRAME -> field.setText(message, as(String.class, at, "a name", value));
        case POINT -> field.set(message, point(at, value));
        default -> field.set(message, elements(at, message.type(), field, value));
      }
    } catch (IllegalArgumentException e) {
      throw new BadInputException(at + ": " + e.getMessage(), e);
    }
  }

  private List<Object> elements(
      String at, MessageType<?> type, MessageField<?> field, Object value) {
    List<Object> elements = new ArrayList<>();
    for (Object each : list(at, value)) {
      String which = at + ", element " + elements.size();
      elements.add(
          switch (field.kind()) {
            case STRING_LIST -> as(String.class, which, "a text", each);
            case BOOLEAN_LIST -> as(Boolean.class, which, "true or false", each);
            case DOUBLE_LIST -> number(which, field.unit(), each);
            case POINT_LIST -> point(which, each);
            default -> within(which, type.elementType(field), each);
          });
    }
    return elements;
  }

  private U2SAData within(String at, Optional<MessageType<?>> declared, Object value) {
    Map<String, Object> json = asMap(at, value);
    return message(at, named(at, json, declared), json);
  }

  /**
   * Type given by the object's {@code "type"}, or the default.
   *
   * @throws BadInputException if the type is unknown, or absent without a default
   */
  public MessageType<?> named(
      String origin, Map<String, Object> json, Optional<? extends MessageType<?>> otherwise) {
    Object name = json.get(TYPE);
    if (name == null) {
      if (otherwise.isPresent()) {
        return otherwise.get();
      }
      throw new BadInputException(origin + ": expected \"type\" with the name of a message type");
    }
    String text = as(String.class, origin + ": \"type\"", "the name of a message type", name);
    Optional<MessageType<?>> known = types.byName(text);
    if (known.isPresent()) {
      return known.get();
    }
    throw new BadInputException(
        String.format(
            "%s: no message type \"%s\" is known%s",
            origin,
            text,
            NearestNames.didYouMean(
                text, types.all().stream().map(MessageType::name).collect(Collectors.toList()))));
  }

  private static double number(String at, String unit, Object value) {
    if (value instanceof Number number) {
      return number.doubleValue();
    }
    Optional<NumberWithUnit> typed =
        value instanceof String text ? NumberWithUnit.of(text) : Optional.empty();
    if (typed.isEmpty()) {
      throw expected(at, "a number" + (unit.isEmpty() ? "" : " [" + unit + "]"), value);
    }
    if (unit.isEmpty()) {
      throw expected(at, "a number without a unit", value);
    }
    return typed.get().in(unit);
  }

  private static Point point(String at, Object value) {
    List<?> parts = list(at, value);
    if (parts.size() < 2 || parts.size() > 3) {
      throw expected(at, "two or three numbers [x, y, z]", value);
    }
    double z = parts.size() == 3 ? number(at, "", parts.get(2)) : 0.0;
    return Point.of(number(at, "", parts.get(0)), number(at, "", parts.get(1)), z);
  }

  private static List<?> list(String at, Object value) {
    if (value instanceof List<?> list) {
      return list;
    }
    throw expected(at, "a list", value);
  }

  @SuppressWarnings("unchecked") // JsonReader only creates maps with text keys
  private static Map<String, Object> asMap(String at, Object value) {
    if (value instanceof Map<?, ?> map) {
      return (Map<String, Object>) map;
    }
    throw expected(at, "an object", value);
  }

  private static <V> V as(Class<V> kind, String at, String what, Object value) {
    if (kind.isInstance(value)) {
      return kind.cast(value);
    }
    throw expected(at, what, value);
  }

  private static BadInputException expected(String at, String what, Object value) {
    Object shown = value instanceof Optional<?> ? "null" : value;
    String text = value instanceof String ? "\"" + shown + "\"" : String.valueOf(shown);
    return new BadInputException(at + ": expected " + what + ", not " + text);
  }
}
