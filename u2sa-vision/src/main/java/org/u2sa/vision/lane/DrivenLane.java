package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;

/**
 * Boundaries of the lane the vehicle has driven in, including stretches where no line was seen. At
 * each driven position, lines are searched to the left and right, perpendicular to the path. Where
 * a line is missing, the lane width is kept: between two positions with both lines known, and as
 * far as the other line extends within a lane's width of the path. Coordinates in metres from the
 * map's anchor.
 */
final class DrivenLane {
  private static final double STEP_M = 0.3; // spacing of positions
  private static final double BACK_M = 0.29; // closer to an earlier position: the same position
  private static final int MAX_PLACES = 300; // 90 m
  private static final int LOOKED_AT = 50; // newest positions, whose sides are still searched
  private static final int CHORD = 3; // positions to either side that define the direction
  private static final int LANE_PLACES = 4; // consecutive two-line positions that make a lane
  private static final double STRAND_M = 0.9; // farther positions belong to another stretch
  private static final double JUMP_M = 0.6; // maximum lateral jump of a side between positions
  private static final double SPREAD = 0.15; // tolerance added per metre without that side
  private static final double OWN_SHARE = 0.75; // fraction of its distance to keep from the path
  private static final double BRIDGE_GAPS = 2.0; // consecutive gaps in the paint
  private static final double BEHIND_M = 6.0; // path kept open for backing out
  private static final long HELD_UP_MICROS = 25 * Clock.MICROS_PER_SECOND;
  private static final double HOLE_M = 1.5; // longest step along an inferred side
  private static final double BARRIER_M = 2.0; // minimum length of a blocking line

  /** A candidate line, and whether it is certain. */
  record Known(List<Point> line, boolean sure) {}

  /**
   * An inferred side, where no line is certain.
   *
   * @param atVehicle whether it reaches the vehicle's current position and may be extended beyond
   */
  record Inferred(List<Point> points, boolean atVehicle) {}

  private final List<LanePlace> places = new ArrayList<>();
  private double[][] ways = {}; // path direction at each position, as of the last sides
  private int now = -1; // index of the vehicle's current position
  private long addedMicros; // time of the newest position

  void clear() {
    places.clear();
    now = -1;
  }

  /** Adds the vehicle's position at a time [µs]. */
  void at(Point at, long micros) {
    now = -1;
    for (int i = places.size() - 1; i >= 0 && now < 0; i--) {
      now = LineGeometry.metres(places.get(i).at, at) < BACK_M ? i : now;
    }
    LanePlace last = places.isEmpty() ? null : places.get(places.size() - 1);
    double gone = last == null ? STRAND_M : LineGeometry.metres(last.at, at);
    if (gone >= STEP_M && now < 0) {
      places.add(new LanePlace(at, gone >= STRAND_M));
      addedMicros = micros;
      if (places.size() > MAX_PLACES) {
        places.remove(0);
      }
    }
    now = now < 0 ? places.size() - 1 : now;
  }

  /** Whether the vehicle has made no progress for long. */
  boolean isHeldUp(long micros) {
    return micros - addedMicros > HELD_UP_MICROS;
  }

  /**
   * Cross-section closing the lane behind the vehicle; empty if it was in no lane or has backed out
   * past it. As of the last {@link #sides}.
   */
  List<Point> wayBack() {
    double gone = 0.0;
    for (int i = places.size() - 1; i > 0; i--) {
      if (gone >= BEHIND_M && places.get(i).hasSides()) {
        return i < now
            ? List.of(beside(i, places.get(i).left.awayM), beside(i, -places.get(i).right.awayM))
            : List.of();
      }
      gone += LineGeometry.metres(places.get(i).at, places.get(i - 1).at);
    }
    return List.of();
  }

  /** Inferred sides of the lane, where no line is certain. */
  List<Inferred> sides(List<Known> known, LineGaps.Reach reach) {
    int from = Math.max(0, places.size() - LOOKED_AT);
    ways = new double[places.size()][];
    Arrays.setAll(ways, this::direction);
    follow(from, known, reach);
    bridge(from, reach);
    List<Known> barriers = barriers(known);
    List<Inferred> sides = new ArrayList<>();
    side(1.0, barriers, sides);
    side(-1.0, barriers, sides);
    return sides;
  }

  /** Finds the lines beside the newest positions and infers the lane where one is missing. */
  private void follow(int from, List<Known> known, LineGaps.Reach reach) {
    LanePlace earlier = from > 0 ? places.get(from - 1) : null;
    double widthM = // of the lane; NaN if in no lane
        earlier == null ? Double.NaN : earlier.left.awayM + earlier.right.awayM;
    double missedM = 0.0; // distance since both lines were seen
    double blindM = 0.0; // distance since any line was seen
    int inRow = 0;
    for (int i = from; i < places.size(); i++) {
      LanePlace place = places.get(i);
      widthM = place.begins ? Double.NaN : widthM;
      boolean inLane = !Double.isNaN(widthM);
      double gateM = inLane ? JUMP_M + SPREAD * missedM : Double.POSITIVE_INFINITY;
      look(i, inLane ? places.get(i - 1) : null, gateM, known, reach);
      place.isLane = reach.isLane(place.left.seenM + place.right.seenM); // false for NaN
      inRow = place.isLane ? inRow + 1 : 0;
      missedM = place.isLane ? 0.0 : missedM + STEP_M;
      boolean blind = Double.isNaN(place.left.seenM) && Double.isNaN(place.right.seenM);
      blindM = blind ? blindM + STEP_M : 0.0;
      if (missedM > BRIDGE_GAPS * reach.gapM() || blindM > reach.aloneM()) {
        widthM = Double.NaN;
      } else if (place.isLane && (inRow >= LANE_PLACES || inLane)) {
        widthM = place.left.seenM + place.right.seenM;
      }
      place.set(widthM, !Double.isNaN(widthM) && i > 0 ? places.get(i - 1) : null);
      if (place.isOutside()) {
        widthM = Double.NaN;
        place.set(widthM, null);
      }
    }
  }

  private void look(
      int i, LanePlace before, double gateM, List<Known> known, LineGaps.Reach reach) {
    double[] along = ways[i];
    for (double sign = 1.0; sign >= -1.0; sign -= 2.0) {
      LanePlace.Side side = places.get(i).side(sign);
      double expectedM = before == null ? 0.0 : before.side(sign).awayM;
      LineRay ray =
          new LineRay(places.get(i).at, -sign * along[1], sign * along[0], reach.widestM());
      Known line = ray.nearest(known, expectedM);
      boolean isSide = line != null && Math.abs(ray.metres() - expectedM) <= gateM;
      side.seenM = isSide ? ray.metres() : Double.NaN;
      side.sure = isSide && line.sure();
    }
  }

  /** Interpolates the lane linearly between two positions where both lines are known. */
  private void bridge(int from, LineGaps.Reach reach) {
    int before = -1;
    for (int i = from; i < places.size(); i++) {
      before = places.get(i).begins ? -1 : before;
      if (places.get(i).isLane) {
        boolean bridged = before >= 0 && (i - before) * STEP_M <= BRIDGE_GAPS * reach.gapM();
        for (int k = before + 1; bridged && k < i; k++) {
          double share = (k - before) / (double) (i - before);
          places.get(k).between(places.get(before), places.get(i), share);
        }
        before = i;
      }
    }
  }

  /** Builds the inferred stretches of one side (1: left). */
  private void side(double sign, List<Known> barriers, List<Inferred> sides) {
    List<Point> string = new ArrayList<>();
    for (int i = 0; i < places.size(); i++) {
      LanePlace place = places.get(i);
      LanePlace.Side side = place.side(sign);
      boolean isSide = !Double.isNaN(side.awayM) && !side.sure;
      double awayM = isSide ? beforeBarrierM(i, sign, side.awayM, barriers) : Double.NaN;
      Point at = isSide ? beside(i, sign * awayM) : place.at;
      isSide &= isClear(i, at, awayM);
      boolean goesOn =
          isSide
              && !string.isEmpty()
              && LineGeometry.metres(string.get(string.size() - 1), at) <= HOLE_M;
      if (!goesOn) {
        add(string, false, sides);
        string = new ArrayList<>();
      }
      if (isSide) {
        string.add(at);
      }
    }
    add(string, now == places.size() - 1, sides);
  }

  private static List<Known> barriers(List<Known> known) {
    return known.stream()
        .filter(each -> each.sure() && LineGeometry.lengthM(each.line()) >= BARRIER_M)
        .collect(Collectors.toList());
  }

  /**
   * Distance of a side, at most that of the nearest certain line: in open ground such as no-man's
   * land an apparent lane width is a coincidence, and lines inferred from it would block the next
   * lane.
   */
  private double beforeBarrierM(int i, double sign, double awayM, List<Known> barriers) {
    double[] along = ways[i];
    LineRay ray = new LineRay(places.get(i).at, -sign * along[1], sign * along[0], awayM);
    return ray.nearest(barriers, 0.0) == null ? awayM : ray.metres();
  }

  private Point beside(int i, double leftM) {
    double[] along = ways[i];
    Point at = places.get(i).at;
    return Point.of(at.x() - leftM * along[1], at.y() + leftM * along[0], 0.0);
  }

  private static void add(List<Point> string, boolean atVehicle, List<Inferred> sides) {
    if (string.size() > 1) {
      sides.add(new Inferred(string, atVehicle));
    }
  }

  /** Whether a side stays beside the path, rather than crossing it as in a tight turn. */
  private boolean isClear(int i, Point side, double awayM) {
    int span = (int) Math.ceil(2.0 * awayM / STEP_M);
    for (int k = Math.max(0, i - span); k < Math.min(places.size(), i + span); k++) {
      if (LineGeometry.metres(side, places.get(k).at) < OWN_SHARE * awayM) {
        return false;
      }
    }
    return true;
  }

  /** Path direction at a position, as a unit vector. */
  private double[] direction(int i) {
    int first = i;
    int last = i;
    while (first > 0 && i - first < CHORD && !places.get(first).begins) {
      first--;
    }
    while (last < places.size() - 1 && last - i < CHORD && !places.get(last + 1).begins) {
      last++;
    }
    Point a = places.get(first).at;
    Point b = places.get(last).at;
    double length = Math.max(1.0e-9, LineGeometry.metres(a, b));
    return new double[] {(b.x() - a.x()) / length, (b.y() - a.y()) / length};
  }
}
