package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.u2sa.messages.RangeScan;

/**
 * Parses an RPLIDAR's output: response descriptors, health, model, motor-board support, and the
 * 5-byte measurements of a standard scan (Slamtec LR001, "RPLIDAR Interface Protocol", rev. 2.1;
 * the board: Slamtec's rplidar_sdk).
 */
final class RplidarParser {
  private static final int SYNC_1 = 0xA5;
  private static final int SYNC_2 = 0x5A;
  private static final int LENGTH_MASK = 0x3FFFFFFF; // the two bits above are the send mode
  private static final int NODE_BYTES = 5;
  private static final double STEPS_PER_DEGREE = 64.0;
  private static final double STEPS_PER_METRE = 4000.0;

  /** Maximum range representable in 16 bits [m]. */
  static final double FARTHEST_M = 65_535 / STEPS_PER_METRE;

  private static final int FULL_TURN = 360 * 64;
  // Random bytes look like a node at one in five positions, so this many in a row are no
  // coincidence.
  private static final int NODES_TO_TRUST = 16;
  private static final int MAX_BEAMS = 20_000; // per scan; a stopped motor sends no scan start

  /**
   * Health reported by the device.
   *
   * @param status 0 good, 1 warning, 2 error (protection stop)
   * @param errorCode manufacturer's error code
   */
  record Health(int status, int errorCode) {}

  /**
   * One revolution.
   *
   * @param firstMicros arrival of its first measurement [µs]
   * @param endMicros arrival of the next revolution's first measurement [µs]
   */
  record Turn(long firstMicros, long endMicros, List<RangeScan.Beam> beams) {}

  /** Parser state: expecting a descriptor, or the announced response. */
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
  private boolean hasBegun; // a scan was received from its start
  private List<RangeScan.Beam> beams = new ArrayList<>();
  private long nowMicros;
  private long firstMicros;
  private Turn ended; // completed revolution, held until enough measurements confirm it
  private int confirmations;
  private Turn whole;
  private Health health;
  private OptionalInt model = OptionalInt.empty();
  private Optional<Boolean> board = Optional.empty();
  private long malformed;

  /** Resets all but the counter before a request, and expects its descriptor. */
  void reset() {
    pendingBytes = 0;
    expecting = Expecting.DESCRIPTOR;
    trusted = true; // data after a descriptor is aligned
    hasBegun = false;
    beams = new ArrayList<>();
    ended = null;
    whole = null;
    health = null;
    model = OptionalInt.empty();
    board = Optional.empty();
  }

  /** Consumes bytes with their arrival time. */
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

  /** Parses at an index; returns the number of bytes consumed, 0 if more are needed. */
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
    return 1; // remainder of a stopped scan
  }

  private int node(int at, int left) {
    if (left < NODE_BYTES) {
      return 0;
    }
    if (!isNode(at)) {
      malformed++;
      trusted = false;
      hasBegun = false; // discard a scan with a gap
      ended = null; // its end may have been misread
      return 1;
    }
    confirm();
    boolean starts = (at(at) & 1) != 0;
    if (starts && hasBegun) {
      ended = new Turn(firstMicros, nowMicros, Collections.unmodifiableList(beams));
      confirmations = 0;
    }
    if (starts || beams.size() >= MAX_BEAMS) {
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

  /** Whether start bit and inverse differ, the check bit is 1, and the angle is valid. */
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

  /** Whether measurements are arriving. */
  boolean isScanning() {
    return expecting == Expecting.NODES;
  }

  /** Health received since the last {@link #reset}. */
  Optional<Health> health() {
    return Optional.ofNullable(health);
  }

  /** Model received since the last {@link #reset}; A2 is 0x28. */
  OptionalInt model() {
    return model;
  }

  /** Motor-board support received since the last {@link #reset}. */
  Optional<Boolean> hasMotorBoard() {
    return board;
  }

  /** Returns the latest complete revolution once. */
  Optional<Turn> takeTurn() {
    Optional<Turn> taken = Optional.ofNullable(whole);
    whole = null;
    return taken;
  }

  /** Number of misaligned measurements. */
  long malformed() {
    return malformed;
  }
}
