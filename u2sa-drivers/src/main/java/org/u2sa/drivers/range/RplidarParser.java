package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.u2sa.messages.RangeScan;

/**
 * Reads what an RPLIDAR sends: response descriptors, its health and model, whether a board runs its
 * motor, and the 5 bytes of each measurement of a standard scan (Slamtec LR001, "RPLIDAR Interface
 * Protocol", rev. 2.1; the board: Slamtec's rplidar_sdk).
 */
final class RplidarParser {
  private static final int SYNC_1 = 0xA5;
  private static final int SYNC_2 = 0x5A;
  private static final int LENGTH_MASK = 0x3FFFFFFF; // the two bits above are the send mode
  private static final int NODE_BYTES = 5;
  private static final double STEPS_PER_DEGREE = 64.0;
  private static final double STEPS_PER_METRE = 4000.0;

  /** The farthest that 16 bits can say [m]. */
  static final double FARTHEST_M = 65_535 / STEPS_PER_METRE;

  private static final int FULL_TURN = 360 * 64;
  // A position in random bytes looks like a node once in five times: so many in a row are no
  // chance.
  private static final int NODES_TO_TRUST = 16;
  private static final int MOST_BEAMS = 20_000; // of a scan; a motor that stands sends no begin

  /**
   * The device's own word on itself.
   *
   * @param status 0 good, 1 warning, 2 error: it has stopped to protect itself
   * @param errorCode of the manufacturer
   */
  record Health(int status, int errorCode) {}

  /**
   * One turn.
   *
   * @param firstMicros when its first measurement came [µs]
   * @param endMicros when the first of the next turn came [µs]
   */
  record Turn(long firstMicros, long endMicros, List<RangeScan.Beam> beams) {}

  /** What comes next: a descriptor, or the answer of a type and length that it announced. */
  private enum Expecting {
    DESCRIPTOR(-1, 7),
    HEALTH(0x06, 3),
    INFO(0x04, 20),
    BOARD(0xFF, 4),
    NODES(0x81, NODE_BYTES);

    private final int type;
    private final int bytes;

    Expecting(int type, int bytes) {
      this.type = type;
      this.bytes = bytes;
    }
  }

  private final byte[] pending = new byte[4096];
  private int pendingBytes;
  private Expecting expecting = Expecting.DESCRIPTOR;
  private boolean trusted;
  private boolean hasBegun; // a scan, at its beginning
  private List<RangeScan.Beam> beams = new ArrayList<>();
  private long nowMicros;
  private long firstMicros;
  private Turn ended; // one whose end was seen, until enough measurements confirm it
  private int confirmations;
  private Turn whole;
  private Health health;
  private OptionalInt model = OptionalInt.empty();
  private Optional<Boolean> board = Optional.empty();
  private long malformed;

  /** Forgets all but the count: a request follows, and its descriptor is awaited. */
  void beginAnew() {
    pendingBytes = 0;
    expecting = Expecting.DESCRIPTOR;
    trusted = true; // what follows a descriptor is aligned
    hasBegun = false;
    beams = new ArrayList<>();
    ended = null;
    whole = null;
    health = null;
    model = OptionalInt.empty();
    board = Optional.empty();
  }

  /** Takes the next bytes of the stream, which came then. */
  void accept(byte[] bytes, int length, long cameMicros) {
    nowMicros = cameMicros;
    int from = 0;
    while (from < length) {
      int taken = Math.min(length - from, pending.length - pendingBytes);
      System.arraycopy(bytes, from, pending, pendingBytes, taken);
      pendingBytes += taken;
      from += taken;
      int used = 0;
      int step;
      while ((step = step(used)) > 0) {
        used += step;
      }
      pendingBytes -= used;
      System.arraycopy(pending, used, pending, 0, pendingBytes);
    }
  }

  /** Reads on from there; returns the bytes that are done with, 0 if more must come first. */
  private int step(int at) {
    int left = pendingBytes - at;
    if (expecting == Expecting.NODES) {
      return trusted ? node(at, left) : hunt(at, left);
    }
    if (left < expecting.bytes) {
      return 0;
    }
    if (expecting == Expecting.DESCRIPTOR) {
      return descriptor(at);
    }
    int answered = expecting.bytes;
    switch (expecting) {
      case HEALTH -> health = new Health(at(at), at(at + 1) | at(at + 2) << 8);
      case INFO -> model = OptionalInt.of(at(at));
      default -> board = Optional.of((at(at) & 1) != 0);
    }
    expecting = Expecting.DESCRIPTOR;
    return answered;
  }

  private int at(int index) {
    return pending[index] & 0xFF;
  }

  private int descriptor(int at) {
    if (at(at) == SYNC_1 && at(at + 1) == SYNC_2) {
      int word = at(at + 2) | at(at + 3) << 8 | at(at + 4) << 16 | at(at + 5) << 24;
      int bytes = word & LENGTH_MASK;
      for (Expecting answer : Expecting.values()) {
        if (at(at + 6) == answer.type && bytes == answer.bytes) {
          expecting = answer;
          return Expecting.DESCRIPTOR.bytes;
        }
      }
    }
    return 1; // rests of a scan that was stopped
  }

  private int node(int at, int left) {
    if (left < NODE_BYTES) {
      return 0;
    }
    if (!isNode(at)) {
      malformed++;
      trusted = false;
      hasBegun = false; // a scan with a gap is none
      ended = null; // nor one whose end may have been none
      return 1;
    }
    confirm();
    boolean starts = (at(at) & 1) != 0;
    if (starts && hasBegun) {
      ended = new Turn(firstMicros, nowMicros, Collections.unmodifiableList(beams));
      confirmations = 0;
    }
    if (starts || beams.size() >= MOST_BEAMS) {
      beams = new ArrayList<>(beams.size());
      hasBegun = starts;
      firstMicros = nowMicros;
    }
    int distance = at(at + 3) | at(at + 4) << 8;
    if (hasBegun) {
      double angle = Math.toRadians(angleSteps(at) / STEPS_PER_DEGREE); // clockwise from above
      beams.add(
          new RangeScan.Beam(
              -angle,
              distance == 0 // no echo
                  ? OptionalDouble.empty()
                  : OptionalDouble.of(distance / STEPS_PER_METRE)));
    }
    return NODE_BYTES;
  }

  private void confirm() {
    if (ended != null && ++confirmations >= NODES_TO_TRUST) {
      whole = ended;
      ended = null;
    }
  }

  /** Whether start bit and its inverse differ, the check bit is 1, and the angle is one. */
  private boolean isNode(int at) {
    return (at(at) & 1) != (at(at) >> 1 & 1) && (at(at + 1) & 1) == 1 && angleSteps(at) < FULL_TURN;
  }

  private int angleSteps(int at) {
    return at(at + 1) >> 1 | at(at + 2) << 7;
  }

  private int hunt(int at, int left) {
    if (left < NODES_TO_TRUST * NODE_BYTES) {
      return 0;
    }
    for (int node = 0; node < NODES_TO_TRUST; node++) {
      if (!isNode(at + node * NODE_BYTES)) {
        return 1;
      }
    }
    trusted = true;
    return node(at, left);
  }

  /** Whether measurements come. */
  boolean isScanning() {
    return expecting == Expecting.NODES;
  }

  /** What was said of health since the last {@link #beginAnew}. */
  Optional<Health> health() {
    return Optional.ofNullable(health);
  }

  /** The model that the device says it is, since the last {@link #beginAnew}; A2 is 0x28. */
  OptionalInt model() {
    return model;
  }

  /** Whether it says that a board runs its motor, since the last {@link #beginAnew}. */
  Optional<Boolean> hasMotorBoard() {
    return board;
  }

  /** The newest whole turn; once. */
  Optional<Turn> takeTurn() {
    Optional<Turn> taken = Optional.ofNullable(whole);
    whole = null;
    return taken;
  }

  /** How often measurements were out of step. */
  long malformed() {
    return malformed;
  }
}
