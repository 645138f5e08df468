package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.Cbor;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.FieldLabels;
import org.u2sa.messages.cbor.Flags;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.Numbers;
import org.u2sa.messages.cbor.TypedArrays;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Reads one message from untrusted bytes: all lengths are bounded, and all errors are {@link
 * MalformedMessageException}s.
 */
final class CborReader {
  private static final FieldKey TYPE_NAME = WireForm.READABLE.key(Schema.TYPE_KEY);
  private static final FieldKey TYPE_LABEL = WireForm.COMPACT.key(Schema.TYPE_KEY);
  private static final FieldKey ORIGIN_NAME = WireForm.READABLE.key(Origin.KEY);
  private static final FieldKey ORIGIN_LABEL = WireForm.COMPACT.key(Origin.KEY);
  private static final int COORDINATES = 3;
  private static final double FULL_LATITUDE_DEG = 90.0;
  private static final int BETWEEN = -1; // between fields
  private static final int OTHER = -2; // a field without an index
  private static final int SOME = 16; // initial capacity of indefinite-length lists

  /** Memory per element of a list or map: a point or short text and the reference to it [B]. */
  private static final int ELEMENT_BYTES = 48;

  private static final int NESTED_BYTES = 400; // per message within a message, beside its lists

  /** Reads the next element of a list. */
  interface Element<V> {
    V read() throws MalformedMessageException;
  }

  private final MessageTypes types;
  private final CborInput in;
  private final List<String> chain; // of the whole message
  private String path; // enclosing types and fields; null: the message's own type
  private FieldTable<?> table; // of the message being read
  private int index =
      BETWEEN; // index of the current field; not a reference, to avoid write barriers
  private String other; // current key without an index
  private int depth; // nesting depth of arrays and maps
  private Origin origin; // from the outermost map; null if absent
  private long more; // memory taken beyond the bytes read [B]

  private CborReader(MessageTypes types, List<String> chain, CborInput in) {
    this.types = types;
    this.chain = chain;
    this.in = in;
  }

  static U2SAData message(MessageTypes types, List<String> chain, CborInput in)
      throws MalformedMessageException {
    return new CborReader(types, chain, in).whole(types.nearest(chain));
  }

  private U2SAData whole(MessageType<?> nearest) throws MalformedMessageException {
    try {
      U2SAData message = message(nearest, chain, in.map(), 0);
      if (origin != null) {
        message.cameFrom(origin);
      }
      if (!in.isAtEnd()) {
        throw malformed("expected the end of the message, not more bytes");
      }
      message.decodedFrom((int) Math.min(Integer.MAX_VALUE, in.offset() + more));
      return message;
    } catch (RuntimeException e) { // from the input or a setter
      throw new MalformedMessageException(where(), in.offset(), e.getMessage(), e);
    }
  }

  /** Reads the rest of an opened map as a message of the given type. */
  private <M extends U2SAData> M message(
      MessageType<M> type, List<String> itsChain, long pairs, long read)
      throws MalformedMessageException {
    M message = type.newCarrier();
    FieldTable<M> fields = type.table(in.isLabelNext() ? WireForm.COMPACT : WireForm.READABLE);
    table = fields;
    deeper();
    boolean isKnown = type.chain() == itsChain || type.chain().equals(itsChain);
    Map<String, Object> unknown = isKnown ? null : new LinkedHashMap<>();
    long done = fields.readInOrder(this, in, message, pairs, read);
    if (done == pairs - 1 && depth == 1 && (in.take(ORIGIN_NAME) || in.take(ORIGIN_LABEL))) {
      reading(Origin.KEY);
      origin = origin();
    } else if (done != pairs) {
      new FieldsReader<>(this, in, message, type, fields, unknown).readRest(pairs, done);
    }
    if (!isKnown) {
      message.keepUnknown(
          new U2SAData.UnknownPart(List.copyOf(itsChain), Collections.unmodifiableMap(unknown)));
    }
    index = BETWEEN;
    MessageField<M> missing = fields.missing(message);
    if (missing != null) {
      throw malformed(missing.path() + " is required and missing");
    }
    requireOnEarth(message);
    message.requireConsistent();
    depth--;
    return message;
  }

  /** Rejects latitudes beyond 90°, so that users of messages in GLOBAL need not check. */
  private <M extends U2SAData> void requireOnEarth(M message) throws MalformedMessageException {
    MessageType<?> type = message.type();
    if (type.frameField() == null || !message.frame().equals(ReferenceFrame.GLOBAL)) {
      return;
    }
    if (type.latitudeField() != null) {
      requireLatitude(message.storage().get(type.latitudeField()));
    }
    for (int slot : type.pointLists()) {
      for (Point point : message.storage().points(slot)) {
        requireLatitude(point.y());
      }
    }
  }

  private void requireLatitude(double degrees) throws MalformedMessageException {
    if (Math.abs(degrees) > FULL_LATITUDE_DEG) { // false for NaN, which means absent
      throw malformed("the latitude " + degrees + " deg is outside -90…90 deg");
    }
  }

  /** Records the index of the current field, for errors. */
  void reading(int field) {
    index = field;
  }

  /** Records the current key, for errors. */
  void reading(String key) {
    other = key;
    index = OTHER;
  }

  /** Reads the value of an unknown key. */
  void other(String name, Map<String, Object> unknown) throws MalformedMessageException {
    if (depth == 1 && name.equals(Origin.KEY)) {
      origin = origin();
    } else if (unknown != null && !name.equals(Schema.TYPE_KEY)) {
      unknown.put(name, AnyValue.read(this));
    } else {
      in.skip(Limits.DEPTH - depth);
    }
  }

  /** Reads [sender, sequence]. */
  private Origin origin() throws MalformedMessageException {
    if ((in.next() & Cbor.MAJOR) != Cbor.ARRAY) {
      throw in.unexpected("an array of sender and sequence");
    }
    long length = in.array();
    String sender = in.text();
    long sequence = in.count();
    if (!in.isDone(length, Origin.ELEMENTS)) {
      throw malformed("expected the end of the array after sender and sequence");
    }
    return new Origin(sender, sequence);
  }

  /** Reads a list element: a map that starts with its type chain. */
  <M extends U2SAData> M nested(MessageType<M> expected) throws MalformedMessageException {
    long pairs = in.map();
    boolean opensWithType =
        !in.isDone(pairs, 0)
            && (in.take(TYPE_NAME) || in.take(TYPE_LABEL) || Schema.TYPE_KEY.equals(key()));
    if (!opensWithType) {
      throw malformed("expected \"type\" as the first key of a message in a list");
    }
    List<String> itsChain = list(in::text);
    MessageType<?> type = types.nearest(itsChain, in.offset());
    if (!expected.messageClass().isAssignableFrom(type.messageClass())) {
      throw malformed("expected a kind of " + expected.name() + ", not " + itsChain);
    }
    String outerPath = path;
    FieldTable<?> outerTable = table;
    int outerIndex = index;
    path = where();
    index = BETWEEN;
    more += NESTED_BYTES;
    M message = expected.messageClass().cast(message(type, itsChain, pairs, 1));
    path = outerPath;
    table = outerTable;
    index = outerIndex;
    return message;
  }

  /** Reads the next key in either form and returns its name. */
  String key() {
    boolean isLabel = (in.next() & Cbor.MAJOR) == Cbor.UNSIGNED;
    return isLabel ? FieldLabels.name(in.count()) : FieldLabels.name(in.text());
  }

  double number() {
    return in.number();
  }

  long count() {
    return in.count();
  }

  boolean flag() {
    return in.flag();
  }

  String text() {
    return in.text();
  }

  ByteString byteString() {
    return in.byteString();
  }

  Point point() throws MalformedMessageException {
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
    ScalarKinds.requireNear(x);
    ScalarKinds.requireNear(y);
    ScalarKinds.requireNear(z);
    return Point.of(x, y, z);
  }

  /** Reads a list of unboxed numbers, plain or as a typed array. */
  List<Double> numbers() throws MalformedMessageException {
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
  List<Point> points() throws MalformedMessageException {
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
  List<?> typedArray() throws MalformedMessageException {
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

  /** Reads a list of unboxed booleans. */
  List<Boolean> flags() throws MalformedMessageException {
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

  <V> List<V> list(Element<V> element) throws MalformedMessageException {
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

  Map<String, Object> map() throws MalformedMessageException {
    long length = in.map();
    deeper();
    Map<String, Object> map = new LinkedHashMap<>();
    while (!in.isDone(length, map.size())) {
      String name = key();
      if (map.put(name, AnyValue.read(this)) != null) {
        throw malformed("the key \"" + name + "\" comes twice");
      }
    }
    depth--;
    more += 2L * ELEMENT_BYTES * map.size();
    return Collections.unmodifiableMap(map);
  }

  /** Peeks at the first byte of the next item. */
  int next() {
    return in.next();
  }

  IllegalArgumentException unexpected(String what) {
    return in.unexpected(what);
  }

  private void deeper() throws MalformedMessageException {
    if (++depth > Limits.DEPTH) {
      throw malformed("expected at most " + Limits.DEPTH + " levels of nesting");
    }
  }

  MalformedMessageException malformed(String what) {
    return new MalformedMessageException(where(), in.offset(), what);
  }

  /** "GoalList.goals.uid". */
  private String where() {
    String around = path == null ? chain.get(chain.size() - 1) : path;
    return switch (index) {
      case BETWEEN -> around;
      case OTHER -> around + "." + other;
      default -> around + "." + table.at(index).name();
    };
  }
}
