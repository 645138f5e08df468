package org.u2sa.messages.schema;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Kinds of single values. */
final class ScalarKinds {
  static final ValueKind<String> TEXT =
      new SingleKind<>(
          Kind.STRING, ScalarKinds::text, text -> text, CborOutput::text, CborReader::text);
  static final ValueKind<ByteString> BYTES =
      new SingleKind<>(
          Kind.BYTES,
          ScalarKinds::bytes,
          ByteString::ofBase64,
          CborOutput::byteString,
          CborReader::byteString);
  static final ValueKind<Long> COUNT =
      new SingleKind<>(
          Kind.LONG,
          ScalarKinds::count,
          ScalarKinds::parseCount,
          (out, count) -> out.count(count),
          CborReader::count);
  static final ValueKind<Boolean> FLAG =
      new SingleKind<>(
          Kind.BOOLEAN,
          value -> instance(value, Boolean.class, "true or false"),
          ScalarKinds::parseFlag,
          (out, flag) -> out.flag(flag),
          CborReader::flag);
  static final ValueKind<ReferenceFrame> FRAME =
      new SingleKind<>(
          Kind.FRAME,
          value -> instance(value, ReferenceFrame.class, "a reference frame"),
          ReferenceFrame::parse,
          (out, frame) -> out.text(frame.name()),
          in -> ReferenceFrame.parse(in.text()));
  static final ValueKind<Point> POINT =
      new SingleKind<>(
          Kind.POINT,
          ScalarKinds::point,
          ScalarKinds::parsePoint,
          ScalarKinds::writePoint,
          CborReader::point);

  private static final int COORDINATES = 3;

  private ScalarKinds() {}

  static <E extends Enum<E>> ValueKind<E> choice(Class<E> type) {
    return new Choice<>(type);
  }

  private static <V> V instance(Object value, Class<V> type, String what) {
    if (type.isInstance(value)) {
      return type.cast(value);
    }
    throw Limits.expected(what);
  }

  private static String text(Object value) {
    String text = instance(value, String.class, "text");
    if (text.length() > Limits.TEXT_BYTES / 3 // UTF-8 takes at most three bytes per char
        && text.getBytes(StandardCharsets.UTF_8).length > Limits.TEXT_BYTES) {
      throw Limits.expected("at most " + Limits.TEXT_BYTES + " bytes of text");
    }
    requireUnicode(text);
    return text;
  }

  /** Rejects unpaired surrogates, which UTF-8 cannot encode. */
  static void requireUnicode(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (Character.isSurrogate(text.charAt(i))) {
        boolean pair =
            i + 1 < text.length() && Character.isSurrogatePair(text.charAt(i), text.charAt(i + 1));
        if (!pair) {
          throw Limits.expected("Unicode text without unpaired surrogates");
        }
        i++;
      }
    }
  }

  private static ByteString bytes(Object value) {
    ByteString bytes = instance(value, ByteString.class, "bytes");
    if (bytes.length() > Limits.BYTE_STRING_BYTES) {
      throw Limits.expected("at most " + Limits.BYTE_STRING_BYTES + " bytes");
    }
    return bytes;
  }

  private static Point point(Object value) {
    Point point = instance(value, Point.class, "a point");
    Limits.requireCoordinate(point.x());
    Limits.requireCoordinate(point.y());
    Limits.requireCoordinate(point.z());
    return point;
  }

  private static void writePoint(CborOutput out, Point value) {
    out.array(COORDINATES);
    out.number(value.x());
    out.number(value.y());
    out.number(value.z());
  }

  private static Long count(Object value) {
    if (value instanceof Long || value instanceof Integer || value instanceof Short) {
      return ((Number) value).longValue();
    }
    throw Limits.expected("a whole number");
  }

  private static Long parseCount(String text) {
    try {
      return Long.parseLong(text.trim());
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("expected a whole number", e);
    }
  }

  private static Boolean parseFlag(String text) {
    return switch (text.trim().toLowerCase(Locale.ROOT)) {
      case "true" -> true;
      case "false" -> false;
      default -> throw Limits.expected("true or false");
    };
  }

  private static Point parsePoint(String text) {
    String[] parts = text.trim().split("[\\s,]+");
    if (parts.length < 2 || parts.length > 3) {
      throw Limits.expected("a point: two or three numbers");
    }
    try {
      return Point.of(
          Double.parseDouble(parts[0]),
          Double.parseDouble(parts[1]),
          parts.length == 3 ? Double.parseDouble(parts[2]) : 0.0);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("expected a point: two or three numbers", e);
    }
  }

  private record Choice<E extends Enum<E>>(Class<E> type) implements ValueKind<E> {
    @Override
    public Kind kind() {
      return Kind.ENUM;
    }

    @Override
    public E checked(Object value) {
      return instance(value, type, "one of " + Arrays.toString(type.getEnumConstants()));
    }

    @Override
    public E parsed(List<String> texts) {
      return named(ValueKind.only(texts).trim().toUpperCase(Locale.ROOT).replaceAll("[ -]+", "_"));
    }

    @Override
    public List<E> constants() {
      return List.of(type.getEnumConstants());
    }

    private E named(String name) {
      for (E constant : type.getEnumConstants()) {
        if (constant.name().equals(name)) {
          return constant;
        }
      }
      throw Limits.expected("one of " + Arrays.toString(type.getEnumConstants()));
    }

    @Override
    public void write(CborOutput out, E value) {
      out.text(value.name());
    }

    @Override
    public E read(CborReader in) throws MalformedMessageException {
      String name = in.text();
      try {
        return named(name);
      } catch (IllegalArgumentException e) {
        throw new UnknownConstantException(e.getMessage() + ", not \"" + name + "\"");
      }
    }
  }

  /** A kind of single values, given by its four functions. */
  record SingleKind<V>(
      Kind kind, Function<Object, V> check, Function<String, V> parse, Writer<V> out, Reader<V> in)
      implements ValueKind<V> {

    interface Writer<V> {
      void write(CborOutput out, V value);
    }

    interface Reader<V> {
      V read(CborReader in) throws MalformedMessageException;
    }

    @Override
    public V checked(Object value) {
      return check.apply(value);
    }

    @Override
    public V parsed(List<String> texts) {
      return parse.apply(ValueKind.only(texts));
    }

    @Override
    public void write(CborOutput writer, V value) {
      out.write(writer, value);
    }

    @Override
    public V read(CborReader reader) throws MalformedMessageException {
      return in.read(reader);
    }

    /** The reader enforces the same bounds as the check and returns immutable values. */
    @Override
    public V readChecked(CborReader reader) throws MalformedMessageException {
      return in.read(reader);
    }
  }
}
