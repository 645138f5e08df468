package org.u2sa.messages.schema;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.shape.CoverageLedger;

/**
 * Messages of any type with any legal values, made from the schema alone: a new field is covered
 * without a line here.
 */
final class MessageArbitraries {
  private static final int NESTING = 2;

  private MessageArbitraries() {}

  static List<MessageType<?>> concreteTypes() {
    List<MessageType<?>> concrete = new ArrayList<>();
    for (MessageType<?> type : StandardTypes.registry().all()) {
      if (!type.isAbstract()) {
        concrete.add(type);
      }
    }
    return concrete;
  }

  static Arbitrary<U2SAData> anyMessage() {
    return Arbitraries.of(concreteTypes()).flatMap(type -> of(type, NESTING));
  }

  static <T extends U2SAData> Arbitrary<U2SAData> of(MessageType<T> type) {
    return of(type, NESTING);
  }

  private static <T extends U2SAData> Arbitrary<U2SAData> of(MessageType<T> type, int depth) {
    List<Arbitrary<Optional<Object>>> values = new ArrayList<>();
    for (MessageField<T> field : type.fields()) {
      values.add(value(type, field, depth).optional(field.isRequired() ? 1.0 : 0.7));
    }
    return Combinators.combine(values)
        .as(
            made -> {
              T message = type.create();
              for (int i = 0; i < made.size(); i++) {
                MessageField<T> field = type.fields().get(i);
                made.get(i).ifPresent(value -> field.set(message, value));
              }
              makeConsistent(message);
              return message;
            });
  }

  /** Gives fields that depend on each other values that do. */
  private static void makeConsistent(U2SAData message) {
    if (message instanceof OccupancyGrid grid) {
      grid.cells(2, new byte[] {1, -2, 3, OccupancyGrid.UNKNOWN});
    } else if (message instanceof CameraImage image) {
      image.size(4, 3);
    } else if (message instanceof CoverageLedger ledger) {
      byte[] cells = {0, 10, (byte) 200, 40};
      ledger.cells(Point.of(11.5, 48.5, 400.0), 5.0, 2, cells, cells, new byte[8]);
    }
    if (message.type().frameField != null && message.frame().equals(ReferenceFrame.GLOBAL)) {
      for (MessageField<U2SAData> field : message.ownType().fields()) {
        if (field == message.type().latitudeField) {
          field.set(message, 48.5);
        } else if (field.kind() == Kind.POINT) {
          field.set(message, Point.of(11.5, 48.5, 400.0));
        } else if (field.kind() == Kind.POINT_LIST) {
          field.set(message, List.of(Point.of(11.5, 48.5, 400.0)));
        }
      }
    }
    if (message instanceof SearchArea area) {
      Point first = Point.of(11.5, 48.5, 400.0);
      area.corners(List.of(first, Point.of(11.6, 48.5, 400.0), Point.of(11.6, 48.6, 400.0)));
      area.ground(400.0).lowest(410.0).highest(500.0);
    }
  }

  /** Decimal places of a limit. */
  private static int decimals(double limit) {
    return BigDecimal.valueOf(limit).stripTrailingZeros().scale();
  }

  private static Arbitrary<Object> value(MessageType<?> type, MessageField<?> field, int depth) {
    switch (field.kind()) {
      case DOUBLE:
        NumberField<?> number = (NumberField<?>) field;
        return Arbitraries.doubles()
            .between(number.least, number.most)
            .ofScale(Math.max(2, Math.max(decimals(number.least), decimals(number.most))))
            .asGeneric();
      case LONG:
        long most = field instanceof TimestampField<?> ? Limits.TIMESTAMP_MICROS : Long.MAX_VALUE;
        return Arbitraries.longs().between(-most, most).asGeneric();
      case BOOLEAN:
        return Arbitraries.of(true, false).asGeneric();
      case STRING:
        return texts().asGeneric();
      case BYTES:
        return Arbitraries.bytes()
            .array(byte[].class)
            .ofMaxSize(300)
            .map(ByteString::copyOf)
            .asGeneric();
      case STRING_LIST:
        return texts().list().ofMaxSize(4).asGeneric();
      case ENUM:
        return Arbitraries.of(constants((ValueField<?, ?>) field)).asGeneric();
      case FRAME:
        return frames().asGeneric();
      case POINT:
        return points().asGeneric();
      case POINT_LIST:
        return points().list().ofMaxSize(5).asGeneric();
      case DOUBLE_LIST:
        return Arbitraries.doubles()
            .between(-Limits.NUMBER, Limits.NUMBER)
            .list()
            .ofMaxSize(5)
            .asGeneric();
      case BOOLEAN_LIST:
        return Arbitraries.of(true, false).list().ofMaxSize(5).asGeneric();
      case MESSAGE_LIST:
        return nested(type.elementType(field).orElseThrow(), depth - 1)
            .list()
            .ofMaxSize(3)
            .asGeneric();
      default:
        throw new AssertionError("no values for " + field.kind());
    }
  }

  private static Arbitrary<U2SAData> nested(MessageType<?> element, int depth) {
    List<MessageType<?>> kinds = new ArrayList<>();
    for (MessageType<?> type : concreteTypes()) {
      if (element.messageClass().isAssignableFrom(type.messageClass())) {
        kinds.add(type);
      }
    }
    return Arbitraries.of(kinds).flatMap(type -> of(type, depth));
  }

  private static List<Object> constants(ValueField<?, ?> field) {
    return List.copyOf(field.constants());
  }

  private static Arbitrary<String> texts() {
    return Arbitraries.strings().ofMaxLength(12).filter(MessageArbitraries::isUnicode);
  }

  /** Lone surrogates are no text: UTF-8 cannot carry them. */
  static boolean isUnicode(String text) {
    return StandardCharsets.UTF_8.newEncoder().canEncode(text);
  }

  private static Arbitrary<ReferenceFrame> frames() {
    Arbitrary<ReferenceFrame> utm =
        Arbitraries.integers().between(1, 60).map(zone -> ReferenceFrame.utm(zone, zone % 2 == 0));
    Arbitrary<ReferenceFrame> named =
        Arbitraries.of(
            ReferenceFrame.GLOBAL,
            ReferenceFrame.LOCAL_ENU,
            ReferenceFrame.LOCAL_NED,
            ReferenceFrame.BODY,
            ReferenceFrame.BODY_FRD,
            ReferenceFrame.BODY_FLU);
    return Arbitraries.oneOf(utm, named);
  }

  private static Arbitrary<Point> points() {
    Arbitrary<Double> coordinate = Arbitraries.doubles().between(-1e9, 1e9);
    return Combinators.combine(coordinate, coordinate, coordinate).as(Point::of);
  }
}
