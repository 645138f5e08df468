package org.u2sa.messages.schema;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** Kinds of points and lists. */
final class ListKinds {
  static final ValueKind<Point> POINT = new PointKind();
  static final ValueKind<List<String>> TEXTS = new Texts();
  static final ValueKind<List<Point>> POINTS = new Points();
  static final ValueKind<List<Double>> NUMBERS = new Numbers();
  static final ValueKind<List<Boolean>> FLAGS = new Flags();

  private ListKinds() {}

  static <M extends U2SAData> ValueKind<List<M>> messages(MessageType<M> element) {
    return new Messages<>(element);
  }

  private static <V> List<V> elements(Object value, Class<V> type, String what) {
    if (!(value instanceof Collection<?> collection)) {
      throw ScalarKinds.expected("a list of " + what);
    }
    if (collection.size() > Limits.LIST_ELEMENTS) {
      throw ScalarKinds.expected("at most " + Limits.LIST_ELEMENTS + " elements");
    }
    List<V> copy = new ArrayList<>(collection.size());
    for (Object element : collection) {
      if (!type.isInstance(element)) {
        throw ScalarKinds.expected("a list of " + what);
      }
      copy.add(type.cast(element));
    }
    return List.copyOf(copy);
  }

  private record PointKind() implements ValueKind<Point> {
    @Override
    public Kind kind() {
      return Kind.POINT;
    }

    @Override
    public Point checked(Object value) {
      if (value instanceof Point point) {
        return point;
      }
      throw ScalarKinds.expected("a point");
    }

    @Override
    public Point parsed(List<String> texts) {
      String[] parts = ValueKind.only(texts).trim().split("[\\s,]+");
      if (parts.length < 2 || parts.length > 3) {
        throw ScalarKinds.expected("a point: two or three numbers");
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

    @Override
    public void write(CborWriter out, Point value) throws IOException {
      out.point(value);
    }

    @Override
    public Point read(CborReader in) throws IOException, MalformedMessageException {
      return in.point();
    }
  }

  private record Texts() implements ValueKind<List<String>> {
    @Override
    public Kind kind() {
      return Kind.STRING_LIST;
    }

    @Override
    public List<String> checked(Object value) {
      List<String> texts = elements(value, String.class, "texts");
      texts.forEach(ScalarKinds.TEXT::checked);
      return texts;
    }

    @Override
    public List<String> parsed(List<String> texts) {
      List<String> parts = new ArrayList<>();
      for (String text : texts) {
        for (String part : text.split(",")) {
          if (!part.trim().isEmpty()) {
            parts.add(part.trim());
          }
        }
      }
      return parts;
    }

    @Override
    public void write(CborWriter out, List<String> value) throws IOException {
      out.beginList(value.size());
      for (String text : value) {
        out.text(text);
      }
      out.endList();
    }

    @Override
    public List<String> read(CborReader in) throws IOException, MalformedMessageException {
      return in.list(in::text);
    }
  }

  private record Points() implements ValueKind<List<Point>> {
    @Override
    public Kind kind() {
      return Kind.POINT_LIST;
    }

    @Override
    public List<Point> checked(Object value) {
      return elements(value, Point.class, "points");
    }

    @Override
    public List<Point> parsed(List<String> texts) {
      List<Point> points = new ArrayList<>();
      for (String text : texts) {
        for (String part : text.split(";")) {
          if (!part.trim().isEmpty()) {
            points.add(POINT.parsed(List.of(part)));
          }
        }
      }
      return points;
    }

    @Override
    public void write(CborWriter out, List<Point> value) throws IOException {
      out.beginList(value.size());
      for (Point point : value) {
        out.point(point);
      }
      out.endList();
    }

    @Override
    public List<Point> read(CborReader in) throws IOException, MalformedMessageException {
      return in.list(in::point);
    }
  }

  private record Numbers() implements ValueKind<List<Double>> {
    @Override
    public Kind kind() {
      return Kind.DOUBLE_LIST;
    }

    @Override
    public List<Double> checked(Object value) {
      List<Double> numbers = elements(value, Double.class, "numbers");
      for (double number : numbers) {
        if (!Double.isFinite(number)) {
          throw ScalarKinds.expected("finite numbers, not " + number);
        }
      }
      return numbers;
    }

    @Override
    public List<Double> parsed(List<String> texts) {
      List<Double> numbers = new ArrayList<>();
      for (String part : TEXTS.parsed(texts)) {
        try {
          numbers.add(Double.parseDouble(part));
        } catch (NumberFormatException e) {
          throw new IllegalArgumentException("expected numbers, not " + part, e);
        }
      }
      return numbers;
    }

    @Override
    public void write(CborWriter out, List<Double> value) throws IOException {
      out.beginList(value.size());
      for (double number : value) {
        out.number(number);
      }
      out.endList();
    }

    @Override
    public List<Double> read(CborReader in) throws IOException, MalformedMessageException {
      return in.list(in::number);
    }
  }

  private record Flags() implements ValueKind<List<Boolean>> {
    @Override
    public Kind kind() {
      return Kind.BOOLEAN_LIST;
    }

    @Override
    public List<Boolean> checked(Object value) {
      return elements(value, Boolean.class, "true or false");
    }

    @Override
    public List<Boolean> parsed(List<String> texts) {
      List<Boolean> flags = new ArrayList<>();
      for (String part : TEXTS.parsed(texts)) {
        flags.add(ScalarKinds.FLAG.parsed(List.of(part)));
      }
      return flags;
    }

    @Override
    public void write(CborWriter out, List<Boolean> value) throws IOException {
      out.beginList(value.size());
      for (boolean flag : value) {
        out.flag(flag);
      }
      out.endList();
    }

    @Override
    public List<Boolean> read(CborReader in) throws IOException, MalformedMessageException {
      return in.list(in::flag);
    }
  }

  private record Messages<M extends U2SAData>(MessageType<M> element)
      implements ValueKind<List<M>> {
    @Override
    public Kind kind() {
      return Kind.MESSAGE_LIST;
    }

    @Override
    public List<M> checked(Object value) {
      return elements(value, element.messageClass(), element.name() + " messages");
    }

    @Override
    public List<M> parsed(List<String> texts) {
      throw ScalarKinds.expected("elements of " + element.name() + " instead of text");
    }

    @Override
    public void write(CborWriter out, List<M> value) throws IOException {
      out.beginList(value.size());
      for (M message : value) {
        out.nested(message);
      }
      out.endList();
    }

    @Override
    public List<M> read(CborReader in) throws IOException, MalformedMessageException {
      return in.list(() -> in.nested(element));
    }

    @Override
    public MessageType<?> elementType() {
      return element;
    }

    @Override
    public List<M> copied(List<M> value) {
      List<M> copies = new ArrayList<>(value.size());
      for (M message : value) {
        copies.add(element.messageClass().cast(message.copy()));
      }
      return List.copyOf(copies);
    }
  }
}
