package org.u2sa.messages.schema;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.ReferenceFrame;

/** Kinds of single values. */
final class ScalarKinds {
  static final ValueKind<String> TEXT = new Text();
  static final ValueKind<Long> COUNT = new Count();
  static final ValueKind<Boolean> FLAG = new Flag();
  static final ValueKind<ReferenceFrame> FRAME = new Frame();

  private ScalarKinds() {}

  static <E extends Enum<E>> ValueKind<E> choice(Class<E> type) {
    return new Choice<>(type);
  }

  static IllegalArgumentException expected(String what) {
    return new IllegalArgumentException("expected " + what);
  }

  private record Text() implements ValueKind<String> {
    @Override
    public Kind kind() {
      return Kind.STRING;
    }

    @Override
    public String checked(Object value) {
      if (!(value instanceof String text)) {
        throw expected("text");
      }
      if (text.length() > Limits.TEXT_BYTES / 3 // UTF-8 takes at most three bytes a char
          && text.getBytes(StandardCharsets.UTF_8).length > Limits.TEXT_BYTES) {
        throw expected("at most " + Limits.TEXT_BYTES + " bytes of text");
      }
      requireUnicode(text);
      return text;
    }

    @Override
    public String parsed(List<String> texts) {
      return ValueKind.only(texts);
    }

    @Override
    public void write(CborWriter out, String value) throws IOException {
      out.text(value);
    }

    @Override
    public String read(CborReader in) throws IOException, MalformedMessageException {
      return in.text();
    }
  }

  /** Half a surrogate pair is no character, and UTF-8 cannot carry it. */
  static void requireUnicode(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (Character.isSurrogate(text.charAt(i))) {
        boolean pair =
            i + 1 < text.length() && Character.isSurrogatePair(text.charAt(i), text.charAt(i + 1));
        if (!pair) {
          throw expected("Unicode text without half a surrogate pair");
        }
        i++;
      }
    }
  }

  private record Count() implements ValueKind<Long> {
    @Override
    public Kind kind() {
      return Kind.LONG;
    }

    @Override
    public Long checked(Object value) {
      if (value instanceof Long || value instanceof Integer || value instanceof Short) {
        return ((Number) value).longValue();
      }
      throw expected("a whole number");
    }

    @Override
    public Long parsed(List<String> texts) {
      try {
        return Long.parseLong(ValueKind.only(texts).trim());
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException("expected a whole number", e);
      }
    }

    @Override
    public void write(CborWriter out, Long value) throws IOException {
      out.count(value);
    }

    @Override
    public Long read(CborReader in) throws IOException, MalformedMessageException {
      return in.count();
    }
  }

  private record Flag() implements ValueKind<Boolean> {
    @Override
    public Kind kind() {
      return Kind.BOOLEAN;
    }

    @Override
    public Boolean checked(Object value) {
      if (value instanceof Boolean flag) {
        return flag;
      }
      throw expected("true or false");
    }

    @Override
    public Boolean parsed(List<String> texts) {
      switch (ValueKind.only(texts).trim().toLowerCase(Locale.ROOT)) {
        case "true":
          return true;
        case "false":
          return false;
        default:
          throw expected("true or false");
      }
    }

    @Override
    public void write(CborWriter out, Boolean value) throws IOException {
      out.flag(value);
    }

    @Override
    public Boolean read(CborReader in) throws IOException, MalformedMessageException {
      return in.flag();
    }
  }

  private record Frame() implements ValueKind<ReferenceFrame> {
    @Override
    public Kind kind() {
      return Kind.FRAME;
    }

    @Override
    public ReferenceFrame checked(Object value) {
      if (value instanceof ReferenceFrame frame) {
        return frame;
      }
      throw expected("a reference frame");
    }

    @Override
    public ReferenceFrame parsed(List<String> texts) {
      return ReferenceFrame.parse(ValueKind.only(texts));
    }

    @Override
    public void write(CborWriter out, ReferenceFrame value) throws IOException {
      out.text(value.name());
    }

    @Override
    public ReferenceFrame read(CborReader in) throws IOException, MalformedMessageException {
      return ReferenceFrame.parse(in.text());
    }
  }

  private record Choice<E extends Enum<E>>(Class<E> type) implements ValueKind<E> {
    @Override
    public Kind kind() {
      return Kind.ENUM;
    }

    @Override
    public E checked(Object value) {
      if (type.isInstance(value)) {
        return type.cast(value);
      }
      throw expected("one of " + Arrays.toString(type.getEnumConstants()));
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
      throw expected("one of " + Arrays.toString(type.getEnumConstants()));
    }

    @Override
    public void write(CborWriter out, E value) throws IOException {
      out.text(value.name());
    }

    @Override
    public E read(CborReader in) throws IOException, MalformedMessageException {
      String name = in.text();
      try {
        return named(name);
      } catch (IllegalArgumentException e) {
        throw new UnknownConstantException(e.getMessage() + ", not \"" + name + "\"");
      }
    }
  }
}
