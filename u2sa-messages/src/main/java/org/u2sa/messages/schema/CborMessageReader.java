package org.u2sa.messages.schema;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Reads one message and those nested in it; all errors are {@link MalformedMessageException}s. */
final class CborMessageReader extends CborReader {
  private static final FieldKey TYPE_NAME = WireForm.READABLE.key(FieldTable.TYPE_KEY);
  private static final FieldKey TYPE_LABEL = WireForm.COMPACT.key(FieldTable.TYPE_KEY);
  private static final FieldKey ORIGIN_NAME = WireForm.READABLE.key(Origin.KEY);
  private static final FieldKey ORIGIN_LABEL = WireForm.COMPACT.key(Origin.KEY);
  private static final double FULL_LATITUDE_DEG = 90.0;
  private static final int NESTED_BYTES = 400; // per nested message, in addition to its lists

  private final MessageTypes types;

  private CborMessageReader(MessageTypes types, String typeName, CborInput in) {
    super(typeName, in);
    this.types = types;
  }

  static U2SAData message(MessageTypes types, List<String> chain, CborInput in)
      throws MalformedMessageException {
    MessageType<?> nearest = types.nearest(chain);
    return new CborMessageReader(types, chain.get(chain.size() - 1), in).whole(nearest, chain);
  }

  private U2SAData whole(MessageType<?> nearest, List<String> chain)
      throws MalformedMessageException {
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
    names = fields.names;
    deeper();
    boolean isKnown = type.chain() == itsChain || type.chain().equals(itsChain);
    Map<String, Object> unknown = isKnown ? null : new LinkedHashMap<>();
    long done = fields.readInOrder(this, in, message, pairs, read);
    if (done == pairs - 1 && depth == 1 && (in.take(ORIGIN_NAME) || in.take(ORIGIN_LABEL))) {
      reading(Origin.KEY);
      readOrigin();
    } else if (done != pairs) {
      new FieldsReader<>(this, message, type, fields, unknown).readRest(pairs, done);
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
  private void requireOnEarth(U2SAData message) throws MalformedMessageException {
    MessageType<?> type = message.type();
    if (type.frameField == null || !message.frame().equals(ReferenceFrame.GLOBAL)) {
      return;
    }
    if (type.latitudeField != null) {
      requireLatitude(
          type, Kind.DOUBLE, type.latitudeField.slot, type.latitudeField.in(message.storage));
    }
    for (int slot : type.points) {
      if (message.storage.value(slot) instanceof Point point) {
        requireLatitude(type, Kind.POINT, slot, point.y());
      }
    }
    for (int slot : type.pointLists) {
      for (Object point : message.storage.list(slot)) {
        requireLatitude(type, Kind.POINT_LIST, slot, ((Point) point).y());
      }
    }
  }

  private void requireLatitude(MessageType<?> type, Kind kind, int slot, double degrees)
      throws MalformedMessageException {
    if (Math.abs(degrees) > FULL_LATITUDE_DEG) { // false for NaN, which means absent
      throw malformed(
          nameOf(type, kind, slot) + ": the latitude " + degrees + " deg is outside -90…90 deg");
    }
  }

  private static String nameOf(MessageType<?> type, Kind kind, int slot) {
    return type.fields().stream()
        .filter(field -> field.kind() == kind && field.slot == slot)
        .map(MessageField::name)
        .findFirst()
        .orElseThrow();
  }

  /** A map that starts with its type chain. */
  @Override
  <M> M nested(Class<M> expected, String name) throws MalformedMessageException {
    long pairs = in.map();
    boolean opensWithType =
        !in.isDone(pairs, 0)
            && (in.take(TYPE_NAME) || in.take(TYPE_LABEL) || FieldTable.TYPE_KEY.equals(key()));
    if (!opensWithType) {
      throw malformed("expected \"type\" as the first key of a message in a list");
    }
    List<String> itsChain = list(in::text);
    MessageType<?> type = types.nearest(itsChain, in.offset());
    if (!expected.isAssignableFrom(type.messageClass())) {
      throw malformed("expected a kind of " + name + ", not " + itsChain);
    }
    String outerPath = path;
    String[] outerNames = names;
    int outerIndex = index;
    path = where();
    index = BETWEEN;
    int from = in.offset();
    long moreBefore = more;
    more += NESTED_BYTES;
    U2SAData nested = message(type, itsChain, pairs, 1);
    nested.decodedFrom((int) Math.min(Integer.MAX_VALUE, in.offset() - from + more - moreBefore));
    M message = expected.cast(nested);
    path = outerPath;
    names = outerNames;
    index = outerIndex;
    return message;
  }
}
