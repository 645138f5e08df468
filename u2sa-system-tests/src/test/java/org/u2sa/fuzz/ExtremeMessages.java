package org.u2sa.fuzz;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.CoverageLedger;

/**
 * A message of every type at the bounds of its schema: all that a reader lets through, however odd.
 * Made from the schemas, so that a new field is covered without a line here.
 */
final class ExtremeMessages {
  /** At which bounds a message is. */
  enum Extreme {
    /** Longest texts and lists, ordinary numbers. */
    LONG,
    /** Largest numbers, in a local frame. */
    LARGE,
    /** Largest numbers, on the earth. */
    FAR,
    /** Smallest numbers, short lists. */
    SMALL,
    /** Only what must be there, as little as possible. */
    EMPTY
  }

  private static final String THREE_BYTES = "\uffe6";
  private static final int LONGEST_TEXT = 21_845; // such characters in 64 KiB
  private static final double HUGE = 1e15;
  private static final double FARTHEST = 1e9;
  private static final double POLE_DEG = 90.0;
  private static final long LAST_MICROS = Long.MAX_VALUE / 1_000;
  private static final int GRID_SIDE = 300;
  private static final int OUTLINE_CORNERS = 200;
  private static final int LEDGER_SIDE = 100;

  private static final double[] TINY = {1e-300, -1e-300, 1e-160, 1e-9, 1e-3, 10.0, 1e6};

  private final String serviceName;
  private Optional<Random> mixing = Optional.empty(); // bounds differ from field to field

  /**
   * @param serviceName to whom messages are addressed that address one
   */
  ExtremeMessages(String serviceName) {
    this.serviceName = serviceName;
  }

  /**
   * Messages of random types whose fields are at different bounds, or tiny, or ordinary; each three
   * times.
   */
  List<U2SAData> mixed(Random random, int count) {
    mixing = Optional.of(random);
    List<MessageType<?>> types =
        StandardTypes.registry().all().stream().filter(type -> !type.isAbstract()).toList();
    List<U2SAData> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      U2SAData made = made(types.get(random.nextInt(types.size())), mixed(Extreme.SMALL));
      all.addAll(Collections.nCopies(3, made)); // as often with the same time
    }
    mixing = Optional.empty();
    return all;
  }

  /** The bound, or another one while mixing; long ones are left out. */
  private Extreme mixed(Extreme extreme) {
    return mixing
        .map(random -> Extreme.values()[1 + random.nextInt(Extreme.values().length - 1)])
        .orElse(extreme);
  }

  List<U2SAData> all() {
    List<U2SAData> all = new ArrayList<>();
    for (MessageType<?> type : StandardTypes.registry().all()) {
      if (!type.isAbstract()) {
        for (Extreme extreme : Extreme.values()) {
          all.add(made(type, extreme));
        }
      }
    }
    return all;
  }

  private <T extends U2SAData> T made(MessageType<T> type, Extreme extreme) {
    T message = type.create();
    for (MessageField<T> field : type.fields()) {
      boolean isLeftOut =
          field.name().equals("systemId")
              || field.name().equals("timestamp")
              || extreme == Extreme.EMPTY && !field.isRequired();
      if (!isLeftOut && !field.isSet(message)) {
        field.set(message, value(type, field, mixed(extreme)));
      }
    }
    if (mixing.isEmpty() && (extreme == Extreme.LARGE || extreme == Extreme.SMALL)) {
      message.timestamp(extreme == Extreme.LARGE ? LAST_MICROS : -LAST_MICROS);
    }
    if (message instanceof OccupancyGrid grid) {
      int side = extreme == Extreme.LONG ? GRID_SIDE : extreme == Extreme.EMPTY ? 1 : 3;
      grid.cells(side, new byte[side * side]);
    } else if (message instanceof CameraImage image) {
      image.size(extreme == Extreme.LARGE ? 65_535 : 1, extreme == Extreme.LARGE ? 65_535 : 1);
    }
    if (message instanceof CoverageLedger ledger) {
      int side = extreme == Extreme.LONG ? LEDGER_SIDE : extreme == Extreme.EMPTY ? 1 : 3;
      byte[] cells = new byte[side * side];
      ledger.cells(ledger.corner(), ledger.cell(), side, cells, cells, new byte[2 * cells.length]);
    } else if (message instanceof SearchArea area) {
      area.corners(outline(extreme == Extreme.LONG ? OUTLINE_CORNERS : 3));
      if (extreme != Extreme.EMPTY) {
        area.ground(0.0).lowest(0.0).highest(HUGE);
      }
    }
    return message;
  }

  private static List<Point> outline(int corners) {
    List<Point> outline = new ArrayList<>();
    for (int i = 0; i < corners; i++) {
      double angle = 2.0 * Math.PI * i / corners;
      outline.add(Point.of(11.5 + 0.2 * Math.cos(angle), 48.5 + 0.2 * Math.sin(angle), 0.0));
    }
    return outline;
  }

  private Object value(MessageType<?> type, MessageField<?> field, Extreme extreme) {
    boolean isLong = extreme == Extreme.LONG;
    boolean isLarge = extreme == Extreme.LARGE || extreme == Extreme.FAR;
    switch (field.kind()) {
      case DOUBLE:
        return number((NumberField<?>) field, extreme);
      case LONG:
        return isLarge ? Long.MAX_VALUE : extreme == Extreme.SMALL ? Long.MIN_VALUE : 1L;
      case BOOLEAN:
        return isLong || isLarge;
      case STRING:
        return text((ValueField<?, ?>) field, extreme);
      case BYTES:
        return ByteString.copyOf(new byte[isLong ? 900_000 : 0]);
      case STRING_LIST:
        String text = THREE_BYTES.repeat(isLong ? longest((ValueField<?, ?>) field) : 1);
        return Collections.nCopies(isLong ? 2 : isLarge ? 1_000 : 0, text);
      case DOUBLE_LIST:
        return Collections.nCopies(isLong ? 10_000 : isLarge ? 10 : 0, isLarge ? HUGE : 1.0);
      case BOOLEAN_LIST:
        return Collections.nCopies(isLong ? 10_000 : isLarge ? 10 : 0, isLarge);
      case ENUM:
        List<?> constants = ((ValueField<?, ?>) field).constants();
        return constants.get((constants.size() - 1) * extreme.ordinal() / Extreme.EMPTY.ordinal());
      case FRAME:
        return isLong || extreme == Extreme.FAR
            ? ReferenceFrame.GLOBAL
            : isLarge ? ReferenceFrame.LOCAL_NED : ReferenceFrame.BODY;
      case POINT:
        return point(extreme, isLarge ? FARTHEST : 0.0);
      case POINT_LIST:
        return points(extreme);
      case MESSAGE_LIST:
        return nested(type.elementType(field).orElseThrow(), extreme);
      default:
        throw new AssertionError("no values for " + field.kind());
    }
  }

  private Double number(NumberField<?> field, Extreme extreme) {
    double least = field.min() == Double.NEGATIVE_INFINITY ? -HUGE : field.min();
    double most = field.max() == Double.POSITIVE_INFINITY ? HUGE : field.max();
    if (mixing.isPresent() && mixing.get().nextBoolean()) {
      double tiny = TINY[mixing.get().nextInt(TINY.length)];
      return Math.max(least, Math.min(most, tiny));
    }
    if (extreme == Extreme.FAR && field.name().equals("y")) {
      return Math.min(most, POLE_DEG);
    }
    return switch (extreme) {
      case LARGE, FAR -> most;
      case SMALL -> least;
      default -> Math.max(least, Math.min(most, extreme == Extreme.LONG ? 1.0 : 0.0));
    };
  }

  private String text(ValueField<?, ?> field, Extreme extreme) {
    boolean isAddress = field.name().equals("serviceName") && extreme != Extreme.LONG;
    if (isAddress) {
      return serviceName;
    }
    return extreme == Extreme.LONG ? THREE_BYTES.repeat(longest(field)) : "a";
  }

  private static int longest(ValueField<?, ?> field) {
    return field.shortens() ? LONGEST_TEXT : field.maxLength().orElse(LONGEST_TEXT);
  }

  /** A point as far as its frame allows: those far away are in GLOBAL, where y is a latitude. */
  private static Point point(Extreme extreme, double coordinate) {
    double pole = extreme == Extreme.FAR ? POLE_DEG : FARTHEST;
    return Point.of(coordinate, Math.max(-pole, Math.min(pole, -coordinate)), coordinate);
  }

  private static List<Point> points(Extreme extreme) {
    List<Point> points = new ArrayList<>();
    boolean isLarge = extreme == Extreme.LARGE || extreme == Extreme.FAR;
    int count =
        switch (extreme) {
          case LONG -> 10_000;
          case LARGE, FAR -> 10;
          case SMALL -> 1;
          case EMPTY -> 0;
        };
    for (int i = 0; i < count; i++) {
      double coordinate = isLarge ? (i % 2 == 0 ? FARTHEST : -FARTHEST) : 0.001 * (i % 100);
      points.add(point(extreme, coordinate));
    }
    return points;
  }

  private List<U2SAData> nested(MessageType<?> element, Extreme extreme) {
    List<U2SAData> nested = new ArrayList<>();
    for (MessageType<?> type : StandardTypes.registry().all()) {
      if (!type.isAbstract() && element.messageClass().isAssignableFrom(type.messageClass())) {
        nested.add(made(type, extreme == Extreme.LONG ? Extreme.EMPTY : extreme));
      }
    }
    return extreme == Extreme.EMPTY ? List.of() : nested;
  }
}
