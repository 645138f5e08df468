package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.Cbor;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.FieldLabels;
import org.u2sa.messages.cbor.Flags;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.Numbers;
import org.u2sa.messages.cbor.TypedArrays;
import org.u2sa.messages.frame.Point;

/**
 * Reads the values of one message from untrusted bytes: all lengths are bounded, and errors name
 * the field. {@link CborMessageReader} is the only subclass.
 */
abstract class CborReader {
  static final int BETWEEN = -1; // between fields
  private static final int OTHER = -2; // a field without an index
  private static final int COORDINATES = 3;
  private static final int SOME = 16; // initial capacity of indefinite-length lists

  /** Memory per element of a list or map: a point or short text and the reference to it [B]. */
  private static final int ELEMENT_BYTES = 48;

  interface Element<V> {
    V read() throws MalformedMessageException;
  }

  final CborInput in;
  String path; // enclosing types and fields
  String[] names; // of the fields of the message being read
  int index = BETWEEN; // index of the current field; not a reference, to avoid write barriers
  int depth; // nesting depth of arrays and maps
  Origin origin; // from the outermost map; null if absent
  long more; // memory taken beyond the bytes read [B]
  private String other; // current key without an index

  CborReader(String typeName, CborInput in) {
    path = typeName;
    this.in = in;
  }

  /**
   * Reads a message in a list.
   *
   * @param type required class of the message
   * @param name of that class's message type
   */
  abstract <M> M nested(Class<M> type, String name) throws MalformedMessageException;

  /** Records the index of the current field, for errors. */
  final void reading(int field) {
    index = field;
  }

  /** Records the current key, for errors. */
  final void reading(String key) {
    other = key;
    index = OTHER;
  }

  /** Reads {@link #origin}: [sender, sequence]. */
  final void readOrigin() throws MalformedMessageException {
    if ((in.next() & Cbor.MAJOR) != Cbor.ARRAY) {
      throw in.unexpected("an array of sender and sequence");
    }
    long length = in.array();
    String sender = in.text();
    long sequence = in.count();
    if (!in.isDone(length, Origin.ELEMENTS)) {
      throw malformed("expected the end of the array after sender and sequence");
    }
    origin = new Origin(sender, sequence);
  }

  /** Reads the next key in either form and returns its name. */
  final String key() {
    boolean isLabel = (in.next() & Cbor.MAJOR) == Cbor.UNSIGNED;
    return isLabel ? FieldLabels.name(in.count()) : FieldLabels.name(in.text());
  }

  final double number() {
    return in.number();
  }

  final long count() {
    return in.count();
  }

  final boolean flag() {
    return in.flag();
  }

  final String text() {
    return in.text();
  }

  final ByteString byteString() {
    return in.byteString();
  }

  final Point point() throws MalformedMessageException {
    long length = in.array();
    deeper();
    double x = in.number();
    double y = in.number();
    double z = in.number();
    if (!in.isDone(length, COORDINATES)) {
      throw malformed("expected a point of three numbers");
    }
    depth--;
    return near(x, y, z);
  }

  private static Point near(double x, double y, double z) {
    Limits.requireCoordinate(x);
    Limits.requireCoordinate(y);
    Limits.requireCoordinate(z);
    return Point.of(x, y, z);
  }

  /** Reads a list of unboxed numbers, plain or as a typed array. */
  final List<Double> numbers() throws MalformedMessageException {
    List<Double> typed = typedNumbers();
    if (typed != null) {
      more += (long) Double.BYTES * typed.size();
      return typed; // bounded by the message size; the field's bounds are checked later
    }
    long length = in.array();
    if (length == CborInput.UNTIL_BREAK) {
      return elements(length, in::number);
    }
    requireRoom(length);
    deeper();
    more += Double.BYTES * length;
    double[] numbers = new double[(int) length];
    in.numbers(numbers);
    depth--;
    return Numbers.owning(numbers);
  }

  /** Reads a typed array of floats; otherwise consumes only tags and returns null. */
  private List<Double> typedNumbers() {
    for (long tag = in.tag(); tag >= 0; tag = in.tag()) { // other tags are ignored
      if (TypedArrays.isOfFloats(tag)) {
        return Numbers.owning(TypedArrays.read(in, tag));
      }
    }
    return null;
  }

  /** Reads a list of points, plain or as a two-dimensional array with three columns. */
  final List<Point> points() throws MalformedMessageException {
    for (long tag = in.tag(); tag >= 0; tag = in.tag()) {
      if (tag == TypedArrays.ROW_MAJOR) {
        return rows(
            COORDINATES, (row, at, end) -> near(row.get(at), row.get(at + 1), row.get(at + 2)));
      }
    }
    return list(this::point);
  }

  /** Creates an element from the numbers of a row, from start to end (exclusive). */
  private interface Row<V> {
    V of(List<Double> numbers, int at, int end);
  }

  /**
   * Reads the rest of a two-dimensional array, row-major.
   *
   * @param width required number of columns; 0 for any
   */
  private <V> List<V> rows(int width, Row<V> row) throws MalformedMessageException {
    long parts = in.array();
    deeper();
    long dimensions = in.array();
    deeper();
    long count = in.count();
    long columns = in.count();
    boolean isSquare = in.isDone(dimensions, 2);
    depth--;
    requireRoom(count);
    requireRoom(columns);
    if (!isSquare || count < 0 || columns < 1 || width != 0 && columns != width) {
      throw malformed("expected the dimensions [n, " + (width == 0 ? "m" : width) + "]");
    }
    List<Double> numbers = numbers();
    if (numbers.size() != count * columns || !in.isDone(parts, 2)) {
      throw malformed(
          String.format(
              "expected %s times %s numbers and the end, not %s", count, columns, numbers.size()));
    }
    depth--;
    more += ELEMENT_BYTES * count;
    List<V> rows = new ArrayList<>((int) count);
    for (int at = 0; at < numbers.size(); at += (int) columns) {
      rows.add(row.of(numbers, at, at + (int) columns));
    }
    return rows;
  }

  /**
   * Reads a one- or two-dimensional array of floats as a list, for messages of unknown classes;
   * null if the next item is something else.
   */
  final List<?> typedArray() throws MalformedMessageException {
    for (long tag = in.tag(); tag >= 0; tag = in.tag()) {
      if (TypedArrays.isOfFloats(tag)) {
        List<Double> numbers = Numbers.owning(TypedArrays.read(in, tag));
        requireRoom(numbers.size());
        return Collections.unmodifiableList(numbers);
      }
      if (tag == TypedArrays.ROW_MAJOR) {
        return rows(0, (row, at, end) -> List.copyOf(row.subList(at, end)));
      }
    }
    return null;
  }

  final List<Boolean> flags() throws MalformedMessageException {
    long length = in.array();
    if (length == CborInput.UNTIL_BREAK) {
      return elements(length, in::flag);
    }
    requireRoom(length);
    deeper();
    boolean[] flags = new boolean[(int) length];
    in.flags(flags);
    depth--;
    return Flags.owning(flags);
  }

  final <V> List<V> list(Element<V> element) throws MalformedMessageException {
    return elements(in.array(), element);
  }

  private <V> List<V> elements(long length, Element<V> element) throws MalformedMessageException {
    requireRoom(length);
    deeper();
    List<V> elements = new ArrayList<>(length == CborInput.UNTIL_BREAK ? SOME : (int) length);
    while (!in.isDone(length, elements.size())) {
      requireRoom(elements.size() + 1L);
      elements.add(element.read());
    }
    depth--;
    more += (long) ELEMENT_BYTES * elements.size();
    return elements;
  }

  private void requireRoom(long elements) throws MalformedMessageException {
    if (elements > Limits.LIST_ELEMENTS) {
      throw malformed("expected at most " + Limits.LIST_ELEMENTS + " elements");
    }
  }

  final <V> Map<String, V> map(Element<V> element) throws MalformedMessageException {
    long length = in.map();
    deeper();
    Map<String, V> map = new LinkedHashMap<>();
    while (!in.isDone(length, map.size())) {
      String name = key();
      if (map.put(name, element.read()) != null) {
        throw malformed("the key \"" + name + "\" occurs twice");
      }
    }
    depth--;
    more += 2L * ELEMENT_BYTES * map.size();
    return Collections.unmodifiableMap(map);
  }

  final int next() {
    return in.next();
  }

  final IllegalArgumentException unexpected(String what) {
    return in.unexpected(what);
  }

  final void deeper() throws MalformedMessageException {
    if (++depth > Limits.DEPTH) {
      throw malformed("expected at most " + Limits.DEPTH + " levels of nesting");
    }
  }

  final MalformedMessageException malformed(String what) {
    return new MalformedMessageException(where(), in.offset(), what);
  }

  /** "GoalList.goals.uid". */
  final String where() {
    return switch (index) {
      case BETWEEN -> path;
      case OTHER -> path + "." + other;
      default -> path + "." + names[index];
    };
  }
}
