package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.Flags;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.Numbers;
import org.u2sa.messages.cbor.TypedArrays;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.frame.Point;

/** Kinds of lists, whose elements are checked, parsed, written and read like single values. */
final class ListKinds {
  static final ValueKind<List<String>> TEXTS = new TextList(texts(ScalarKinds.TEXT));
  static final ValueKind<List<Point>> POINTS =
      new PointList(new ListKind<>(Kind.POINT_LIST, Point.class, "points", ";", ScalarKinds.POINT));
  static final ValueKind<List<Double>> NUMBERS = new NumberList();
  static final ValueKind<List<Boolean>> FLAGS = new FlagList();

  private ListKinds() {}

  static ValueKind<List<String>> texts(ValueKind<String> element) {
    return new ListKind<>(Kind.STRING_LIST, String.class, "texts", ",", element);
  }

  static <M extends StoredMessage> ValueKind<List<M>> messages(Class<M> type, String name) {
    return new Messages<>(type, name);
  }

  private static Double parseNumber(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("expected numbers, not " + text, e);
    }
  }

  private static <V> List<V> elements(Object value, Class<V> type, String what) {
    if (!(value instanceof Collection<?> collection)) {
      throw Limits.expected("a list of " + what);
    }
    requireRoom(collection);
    List<V> copy = new ArrayList<>(collection.size());
    for (Object element : collection) {
      if (!type.isInstance(element)) {
        throw Limits.expected("a list of " + what);
      }
      copy.add(type.cast(element));
    }
    return List.copyOf(copy);
  }

  private static void requireRoom(Collection<?> collection) {
    if (collection.size() > Limits.LIST_ELEMENTS) {
      throw Limits.expected("at most " + Limits.LIST_ELEMENTS + " elements");
    }
  }

  private static <V> List<V> split(
      List<String> texts, String separator, Function<String, V> parse) {
    List<V> values = new ArrayList<>();
    for (String text : texts) {
      for (String part : text.split(separator)) {
        if (!part.trim().isEmpty()) {
          values.add(parse.apply(part.trim()));
        }
      }
    }
    return values;
  }

  private record ListKind<V>(
      Kind kind, Class<V> type, String what, String separator, ValueKind<V> element)
      implements ValueKind<List<V>> {
    @Override
    public List<V> checked(Object value) {
      List<V> values = elements(value, type, what);
      values.forEach(element::checked);
      return values;
    }

    @Override
    public List<V> parsed(List<String> texts) {
      return split(texts, separator, part -> element.parsed(List.of(part)));
    }

    @Override
    public void write(CborOutput out, List<V> values) {
      out.array(values.size());
      for (V value : values) {
        element.write(out, value);
      }
    }

    @Override
    public List<V> read(CborReader in) throws MalformedMessageException {
      return in.list(() -> element.read(in));
    }

    @Override
    public int longest() {
      return element.longest();
    }
  }

  /** Base of kinds that override some methods of another kind. */
  interface Derived<V> extends ValueKind<V> {
    ValueKind<V> base();

    @Override
    default Kind kind() {
      return base().kind();
    }

    @Override
    default V checked(Object value) {
      return base().checked(value);
    }

    @Override
    default V parsed(List<String> texts) {
      return base().parsed(texts);
    }

    @Override
    default void write(CborOutput out, V value) {
      base().write(out, value);
    }

    @Override
    default V read(CborReader in) throws MalformedMessageException {
      return base().read(in);
    }
  }

  /** May be kept as {@link DeferredTexts}, which check themselves. */
  private record TextList(ValueKind<List<String>> base) implements Derived<List<String>> {
    @Override
    public List<String> checked(Object value) {
      return value instanceof DeferredTexts later ? later : base.checked(value);
    }
  }

  /** May be a two-dimensional array on the wire. */
  private record PointList(ValueKind<List<Point>> base) implements Derived<List<Point>> {
    @Override
    public void write(CborOutput out, List<Point> values) {
      if (out.form() == WireForm.COMPACT) {
        TypedArrays.writePoints(out, values);
      } else {
        base.write(out, values);
      }
    }

    @Override
    public List<Point> read(CborReader in) throws MalformedMessageException {
      return in.points();
    }
  }

  /** Kept as {@link Numbers}. */
  private record NumberList() implements ValueKind<List<Double>> {
    @Override
    public Kind kind() {
      return Kind.DOUBLE_LIST;
    }

    @Override
    public Numbers checked(Object value) {
      if (!(value instanceof Collection<?> numbers)) {
        throw Limits.expected("a list of numbers");
      }
      requireRoom(numbers);
      return Numbers.of(numbers);
    }

    @Override
    public List<Double> parsed(List<String> texts) {
      return split(texts, ",", ListKinds::parseNumber);
    }

    @Override
    public void write(CborOutput out, List<Double> values) {
      if (out.form() == WireForm.COMPACT) {
        TypedArrays.write(out, Numbers.of(values));
      } else {
        out.numbers(Numbers.of(values));
      }
    }

    @Override
    public List<Double> read(CborReader in) throws MalformedMessageException {
      return in.numbers();
    }
  }

  /** Kept as {@link Flags}. */
  private record FlagList() implements ValueKind<List<Boolean>> {
    @Override
    public Kind kind() {
      return Kind.BOOLEAN_LIST;
    }

    @Override
    public Flags checked(Object value) {
      if (!(value instanceof Collection<?> flags)) {
        throw Limits.expected("a list of true or false");
      }
      requireRoom(flags);
      return Flags.of(flags);
    }

    @Override
    public List<Boolean> parsed(List<String> texts) {
      return split(texts, ",", part -> ScalarKinds.FLAG.parsed(List.of(part)));
    }

    @Override
    public void write(CborOutput out, List<Boolean> values) {
      out.flags(Flags.of(values));
    }

    @Override
    public List<Boolean> read(CborReader in) throws MalformedMessageException {
      return in.flags();
    }
  }

  private record Messages<M extends StoredMessage>(Class<M> type, String name)
      implements ValueKind<List<M>> {
    @Override
    public Kind kind() {
      return Kind.MESSAGE_LIST;
    }

    @Override
    public List<M> checked(Object value) {
      return elements(value, type, name + " messages");
    }

    @Override
    public List<M> parsed(List<String> texts) {
      throw Limits.expected("elements of " + name + " instead of text");
    }

    @Override
    public void write(CborOutput out, List<M> value) {
      out.array(value.size());
      for (M message : value) {
        message.writeNested(out);
      }
    }

    @Override
    public List<M> read(CborReader in) throws MalformedMessageException {
      return in.list(() -> in.nested(type, name));
    }
  }
}
