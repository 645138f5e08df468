package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * Reads what an RPLIDAR sends: response descriptors, its health, and the 5 bytes of each
 * measurement of a standard scan (Slamtec LR001, "RPLIDAR Interface Protocol", rev. 2.1).
 */
final class RplidarParser {
  private static final int SYNC_1 = 0xA5;
  private static final int SYNC_2 = 0x5A;
  private static final int DESCRIPTOR_BYTES = 7;
  private static final int LENGTH_MASK = 0x3FFFFFFF; // the two bits above are the send mode
  private static final int HEALTH_TYPE = 0x06;
  private static final int HEALTH_BYTES = 3;
  private static final int SCAN_TYPE = 0x81;
  private static final int NODE_BYTES = 5;
  private static final double STEPS_PER_DEGREE = 64.0;
  private static final double STEPS_PER_METRE = 4000.0;
  private static final int FULL_TURN = 360 * 64;
  // A position in random bytes looks like a node once in five times: so many in a row are no
  // chance.
  private static final int NODES_TO_TRUST = 16;
  private static final int MOST_POINTS = 20_000; // of a scan; a motor that stands sends no begin

  /**
   * The device's own word on itself.
   *
   * @param status 0 good, 1 warning, 2 error: it has stopped to protect itself
   * @param errorCode of the manufacturer
   */
  record Health(int status, int errorCode) {}

  private enum Expecting {
    DESCRIPTOR,
    HEALTH,
    NODES
  }

  private final byte[] pending = new byte[4096];
  private int pendingBytes;
  private Expecting expecting = Expecting.DESCRIPTOR;
  private boolean trusted;
  private boolean hasBegun; // a scan, at its beginning
  private List<Point> points = new ArrayList<>();
  private List<Point> ended; // a scan whose end was seen, until enough measurements confirm it
  private int confirmations;
  private List<Point> whole;
  private Health health;
  private long malformed;

  /** Forgets all but the count: a request follows, and its descriptor is awaited. */
  void beginAnew() {
    pendingBytes = 0;
    expecting = Expecting.DESCRIPTOR;
    trusted = true; // what follows a descriptor is aligned
    hasBegun = false;
    points = new ArrayList<>();
    ended = null;
    whole = null;
    health = null;
  }

  /** Takes the next bytes of the stream. */
  void accept(byte[] bytes, int length) {
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
    switch (expecting) {
      case DESCRIPTOR:
        return left < DESCRIPTOR_BYTES ? 0 : descriptor(at);
      case HEALTH:
        if (left < HEALTH_BYTES) {
          return 0;
        }
        health = new Health(at(at), at(at + 1) | at(at + 2) << 8);
        expecting = Expecting.DESCRIPTOR;
        return HEALTH_BYTES;
      default:
        return trusted ? node(at, left) : hunt(at, left);
    }
  }

  private int at(int index) {
    return pending[index] & 0xFF;
  }

  private int descriptor(int at) {
    if (at(at) == SYNC_1 && at(at + 1) == SYNC_2) {
      int word = at(at + 2) | at(at + 3) << 8 | at(at + 4) << 16 | at(at + 5) << 24;
      int bytes = word & LENGTH_MASK;
      int type = at(at + 6);
      if (type == HEALTH_TYPE && bytes == HEALTH_BYTES) {
        expecting = Expecting.HEALTH;
        return DESCRIPTOR_BYTES;
      }
      if (type == SCAN_TYPE && bytes == NODE_BYTES) {
        expecting = Expecting.NODES;
        return DESCRIPTOR_BYTES;
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
      ended = points;
      confirmations = 0;
    }
    if (starts || points.size() >= MOST_POINTS) {
      points = new ArrayList<>(points.size());
      hasBegun = starts;
    }
    int distance = at(at + 3) | at(at + 4) << 8;
    if (distance != 0 && hasBegun) { // 0: nothing was measured
      double angle = Math.toRadians(angleSteps(at) / STEPS_PER_DEGREE);
      points.add(Point.polar(-angle, 0.0, distance / STEPS_PER_METRE)); // clockwise from above
    }
    return NODE_BYTES;
  }

  private void confirm() {
    if (ended != null && ++confirmations >= NODES_TO_TRUST) {
      whole = Collections.unmodifiableList(ended);
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

  /** The newest whole scan, in the sensor's axes; once. */
  Optional<List<Point>> takeScan() {
    Optional<List<Point>> taken = Optional.ofNullable(whole);
    whole = null;
    return taken;
  }

  /** How often measurements were out of step. */
  long malformed() {
    return malformed;
  }
}
