package org.u2sa.messages.schema;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.dataformat.cbor.CBORFactory;
import com.fasterxml.jackson.dataformat.cbor.CBORParser;
import java.io.IOException;
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
  private static final CBORFactory FACTORY =
      CBORFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder()
                  .maxNestingDepth(Limits.DEPTH)
                  .maxStringLength(Limits.TEXT_BYTES)
                  .maxNameLength(Limits.TEXT_BYTES)
                  .maxDocumentLength(Limits.PAYLOAD_BYTES)
                  .build())
          .build();

  /** Reads the element of a list that the parser stands on. */
  interface Element<V> {
    V read() throws IOException, MalformedMessageException;
  }

  private final MessageTypes types;
  private final CBORParser in;
  private String path; // type and fields around what is being read, for errors
  private String key; // the field being read; null between fields
  private int depth; // maps around what is being read
  private Origin origin; // as the outermost map says; else null

  private CborReader(MessageTypes types, CBORParser in, String path) {
    this.types = types;
    this.in = in;
    this.path = path;
  }

  static U2SAData message(MessageTypes types, List<String> chain, byte[] bytes)
      throws MalformedMessageException {
    MessageType<?> nearest = types.nearest(chain);
    try (CBORParser parser = FACTORY.createParser(bytes)) {
      CborReader reader = new CborReader(types, parser, chain.get(chain.size() - 1));
      return reader.whole(nearest, chain, bytes.length);
    } catch (IOException e) {
      throw new MalformedMessageException(nearest.name(), 0L, "cannot be opened", e);
    }
  }

  private U2SAData whole(MessageType<?> nearest, List<String> chain, int length)
      throws MalformedMessageException {
    try {
      in.nextToken();
      U2SAData message = map(nearest, chain);
      message.cameFrom(origin);
      if (in.currentLocation().getByteOffset() < length) {
        throw malformed("expected the end of the message, not more bytes");
      }
      return message;
    } catch (IOException | RuntimeException e) {
      // RuntimeException: a setter's refusal, or the parser's own on bytes that its authors did not
      // foresee.
      throw new MalformedMessageException(where(), offset(), reason(e), e);
    }
  }

  private static String reason(Exception e) {
    String message =
        e instanceof JacksonException broken ? broken.getOriginalMessage() : e.getMessage();
    return message == null ? "is no CBOR" : message;
  }

  /** The map that the parser stands on, as a message of the given type. */
  private U2SAData map(MessageType<?> type, List<String> chain)
      throws IOException, MalformedMessageException {
    expect(JsonToken.START_OBJECT, "a map");
    return mapAfterType(type, chain);
  }

  private U2SAData mapAfterType(MessageType<?> type, List<String> chain)
      throws IOException, MalformedMessageException {
    U2SAData message = type.createCarrier().get();
    boolean isKnown = type.chain().equals(chain);
    Map<String, Object> unknown = isKnown ? null : new LinkedHashMap<>();
    fields(message, unknown);
    if (unknown != null) {
      message.keepUnknown(
          new U2SAData.UnknownPart(List.copyOf(chain), Collections.unmodifiableMap(unknown)));
    }
    requireComplete(message);
    return message;
  }

  private void fields(U2SAData message, Map<String, Object> unknown)
      throws IOException, MalformedMessageException {
    String outerPath = path;
    String outerKey = key;
    path = where();
    Set<String> skipped = new HashSet<>();
    depth++;
    for (key = in.nextFieldName(); key != null; key = in.nextFieldName()) {
      MessageField<U2SAData> field = message.ownType().fieldOrNull(key);
      if (field == null ? !skipped.add(key) : field.isSet(message) || skipped.contains(key)) {
        throw malformed("the key comes twice");
      }
      in.nextToken();
      if (field != null) {
        field.read(this, message);
        if (!field.isSet(message)) {
          skipped.add(key); // a constant that only later readers know
        }
      } else if (depth == 1 && key.equals(Origin.KEY)) {
        origin = origin();
      } else if (unknown != null && !key.equals(Schema.TYPE_KEY)) {
        unknown.put(unicode(key), AnyValue.read(this));
      } else {
        in.skipChildren();
      }
    }
    expect(JsonToken.END_OBJECT, "a text key or the end of the map");
    depth--;
    path = outerPath;
    key = outerKey;
  }

  /** What the parser stands on, as [sender, sequence]. */
  private Origin origin() throws IOException, MalformedMessageException {
    expect(JsonToken.START_ARRAY, "an array of sender and sequence");
    in.nextToken();
    String sender = text();
    in.nextToken();
    long sequence = count();
    in.nextToken();
    expect(JsonToken.END_ARRAY, "the end of the array after sender and sequence");
    return new Origin(sender, sequence);
  }

  private void requireComplete(U2SAData message) throws MalformedMessageException {
    for (MessageField<U2SAData> field : message.ownType().fields()) {
      if (field.isRequired() && !field.isSet(message)) {
        throw malformed(field.path() + " is required and missing");
      }
    }
  }

  /** The list element that the parser stands on: a map that opens with its type chain. */
  <M extends U2SAData> M nested(MessageType<M> expected)
      throws IOException, MalformedMessageException {
    expect(JsonToken.START_OBJECT, "a map");
    if (!Schema.TYPE_KEY.equals(in.nextFieldName())) {
      throw malformed("expected \"type\" as the first key of a message in a list");
    }
    in.nextToken();
    List<String> chain = list(this::text);
    MessageType<?> type = types.nearest(chain, offset());
    if (!expected.messageClass().isAssignableFrom(type.messageClass())) {
      throw malformed("expected a kind of " + expected.name() + ", not " + chain);
    }
    return expected.messageClass().cast(mapAfterType(type, chain));
  }

  double number() throws IOException, MalformedMessageException {
    JsonToken token = in.currentToken();
    if (token != JsonToken.VALUE_NUMBER_FLOAT && token != JsonToken.VALUE_NUMBER_INT) {
      throw unexpected("a number");
    }
    return in.getDoubleValue();
  }

  long count() throws IOException, MalformedMessageException {
    if (in.currentToken() != JsonToken.VALUE_NUMBER_INT
        || in.getNumberType() == JsonParser.NumberType.BIG_INTEGER) {
      throw unexpected("an integer of 64 bits");
    }
    return in.getLongValue();
  }

  boolean flag() throws IOException, MalformedMessageException {
    if (in.currentToken() != JsonToken.VALUE_TRUE && in.currentToken() != JsonToken.VALUE_FALSE) {
      throw unexpected("true or false");
    }
    return in.currentToken() == JsonToken.VALUE_TRUE;
  }

  String text() throws IOException, MalformedMessageException {
    expect(JsonToken.VALUE_STRING, "text");
    return unicode(in.getText());
  }

  /** Jackson reads halves of surrogate pairs, which no UTF-8 has and nobody could write again. */
  private static String unicode(String text) {
    ScalarKinds.requireUnicode(text);
    return text;
  }

  Point point() throws IOException, MalformedMessageException {
    List<Double> coordinates = list(this::number);
    if (coordinates.size() != 3) {
      throw malformed("expected a point of three numbers, not of " + coordinates.size());
    }
    return Point.of(coordinates.get(0), coordinates.get(1), coordinates.get(2));
  }

  <V> List<V> list(Element<V> element) throws IOException, MalformedMessageException {
    expect(JsonToken.START_ARRAY, "an array");
    List<V> elements = new ArrayList<>();
    while (in.nextToken() != JsonToken.END_ARRAY) {
      if (elements.size() == Limits.LIST_ELEMENTS) {
        throw malformed("expected at most " + Limits.LIST_ELEMENTS + " elements");
      }
      elements.add(element.read());
    }
    return elements;
  }

  Map<String, Object> map() throws IOException, MalformedMessageException {
    Map<String, Object> map = new LinkedHashMap<>();
    for (String name = in.nextFieldName(); name != null; name = in.nextFieldName()) {
      in.nextToken();
      if (map.put(unicode(name), AnyValue.read(this)) != null) {
        throw malformed("the key \"" + name + "\" comes twice");
      }
    }
    expect(JsonToken.END_OBJECT, "a text key or the end of the map");
    return Collections.unmodifiableMap(map);
  }

  /** What the parser stands on. */
  JsonToken token() {
    return in.currentToken();
  }

  private void expect(JsonToken token, String what) throws IOException, MalformedMessageException {
    if (in.currentToken() != token) {
      throw unexpected(what);
    }
  }

  MalformedMessageException unexpected(String what) {
    JsonToken token = in.currentToken();
    return malformed("expected " + what + ", not " + (token == null ? "the end" : token));
  }

  MalformedMessageException malformed(String what) {
    return new MalformedMessageException(where(), offset(), what);
  }

  /** "GoalList.goals.uid". */
  private String where() {
    return key == null ? path : path + "." + key;
  }

  private long offset() {
    return Math.max(0L, in.currentLocation().getByteOffset());
  }
}
