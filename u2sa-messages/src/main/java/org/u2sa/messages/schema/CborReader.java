package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.messages.frame.Point;

/**
 * Reads one message from hostile bytes: every length is bounded, every error is a {@link
 * MalformedMessageException}.
 */
final class CborReader {
  private static final int COORDINATES = 3;
  private static final int SOME = 16; // elements, to begin with, of a list that does not say

  /** Reads the next element of a list. */
  interface Element<V> {
    V read() throws MalformedMessageException;
  }

  private final MessageTypes types;
  private final CborInput in;
  private String path; // type and fields around what is being read, for errors
  private String key; // the field being read; null between fields
  private int depth; // arrays and maps around what is being read
  private Origin origin; // as the outermost map says; else null

  private CborReader(MessageTypes types, byte[] bytes, String path) {
    this.types = types;
    in = new CborInput(bytes);
    this.path = path;
  }

  static U2SAData message(MessageTypes types, List<String> chain, byte[] bytes)
      throws MalformedMessageException {
    MessageType<?> nearest = types.nearest(chain);
    return new CborReader(types, bytes, chain.get(chain.size() - 1)).whole(nearest, chain);
  }

  private U2SAData whole(MessageType<?> nearest, List<String> chain)
      throws MalformedMessageException {
    try {
      U2SAData message = message(nearest, chain, in.map(), 0);
      message.cameFrom(origin);
      if (!in.isAtEnd()) {
        throw malformed("expected the end of the message, not more bytes");
      }
      return message;
    } catch (RuntimeException e) { // the input's, or a setter's refusal
      throw new MalformedMessageException(where(), in.offset(), e.getMessage(), e);
    }
  }

  /** The rest of the map that was opened, as a message of the given type. */
  private U2SAData message(MessageType<?> type, List<String> chain, long pairs, long read)
      throws MalformedMessageException {
    U2SAData message = type.newCarrier();
    message.storage().expect(pairs, type.sizes());
    boolean isKnown = type.chain().equals(chain);
    Map<String, Object> unknown = isKnown ? null : new LinkedHashMap<>();
    String outerPath = path;
    String outerKey = key;
    path = where();
    key = null;
    deeper();
    fields(message, unknown, pairs, read);
    if (unknown != null) {
      message.keepUnknown(
          new U2SAData.UnknownPart(List.copyOf(chain), Collections.unmodifiableMap(unknown)));
    }
    key = null;
    requireComplete(message);
    depth--;
    path = outerPath;
    key = outerKey;
    return message;
  }

  private void fields(U2SAData message, Map<String, Object> unknown, long pairs, long begun)
      throws MalformedMessageException {
    MessageType<U2SAData> type = message.ownType();
    Set<String> others = Set.of(); // keys without a value in the message
    int next = 0;
    for (long read = begun; !in.isDone(pairs, read); read++) {
      MessageField<U2SAData> field = null;
      int index = type.takeKey(in, next);
      if (index >= 0) { // in the order in which writers put them
        field = type.at(index);
        key = field.name();
        next = index + 1;
      } else {
        key = in.text();
        field = type.fieldOrNull(key);
      }
      boolean isKnownTwice = field != null && field.isSet(message);
      if (isKnownTwice || !others.isEmpty() && others.contains(key)) {
        throw malformed("the key comes twice");
      }
      if (field != null) {
        field.read(this, message);
      } else if (depth == 1 && key.equals(Origin.KEY)) {
        origin = origin();
      } else if (unknown != null && !key.equals(Schema.TYPE_KEY)) {
        unknown.put(key, AnyValue.read(this));
      } else {
        in.skip(Limits.DEPTH - depth);
      }
      if (field == null || !field.isSet(message)) { // the latter: what only later readers know
        others = with(others, key);
      }
    }
  }

  private static Set<String> with(Set<String> keys, String key) {
    Set<String> more = keys.isEmpty() ? new HashSet<>() : keys;
    more.add(key);
    return more;
  }

  /** The next item, as [sender, sequence]. */
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

  private void requireComplete(U2SAData message) throws MalformedMessageException {
    for (MessageField<U2SAData> field : message.ownType().requiredFields()) {
      if (!field.isSet(message)) {
        throw malformed(field.path() + " is required and missing");
      }
    }
  }

  /** The next element of a list: a map that opens with its type chain. */
  <M extends U2SAData> M nested(MessageType<M> expected) throws MalformedMessageException {
    long pairs = in.map();
    boolean opensWithType =
        !in.isDone(pairs, 0)
            && (in.take(Schema.TYPE_KEY_BYTES) || Schema.TYPE_KEY.equals(in.text()));
    if (!opensWithType) {
      throw malformed("expected \"type\" as the first key of a message in a list");
    }
    List<String> chain = list(in::text);
    MessageType<?> type = types.nearest(chain, in.offset());
    if (!expected.messageClass().isAssignableFrom(type.messageClass())) {
      throw malformed("expected a kind of " + expected.name() + ", not " + chain);
    }
    return expected.messageClass().cast(message(type, chain, pairs, 1));
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
    return Point.of(x, y, z);
  }

  /** The next item, as a list of numbers without objects for them. */
  List<Double> numbers() throws MalformedMessageException {
    long length = in.array();
    if (length == CborInput.UNTIL_BREAK) {
      return elements(length, in::number);
    }
    requireRoom(length);
    deeper();
    double[] numbers = new double[(int) length];
    in.numbers(numbers);
    depth--;
    return Numbers.owning(numbers);
  }

  /** The next item, as a list of true and false without a place for each. */
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
      String name = in.text();
      if (map.put(name, AnyValue.read(this)) != null) {
        throw malformed("the key \"" + name + "\" comes twice");
      }
    }
    depth--;
    return Collections.unmodifiableMap(map);
  }

  /** The first byte of the next item. */
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
    return key == null ? path : path + "." + key;
  }
}
