package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;

/**
 * Sides of the lane that the vehicle has driven in, also where no line was seen beside it. At each
 * driven place the lines to the left and to the right are looked for square to the way. Where one
 * is missing, the lane goes on as wide as it was: between two places where both lines are known,
 * and as far as the other line leads within a lane's width of the way. Metres from the map's
 * anchor.
 */
final class DrivenLane {
  private static final double STEP_M = 0.3; // from one place to the next
  private static final double BACK_M = 0.29; // nearer to an earlier place it is that place again
  private static final int MAX_PLACES = 300; // 90 m
  private static final int LOOKED_AT = 50; // newest places, whose sides are still looked for
  private static final int CHORD = 3; // places to either side that give the direction of the way
  private static final int LANE_PLACES = 4; // in a row with both lines make a lane
  private static final double STRAND_M = 0.9; // a farther place belongs to another piece of the way
  private static final double JUMP_M = 0.6; // by which a side may move from place to place
  private static final double SPREAD = 0.15; // more for each metre without that side
  private static final double OWN_SHARE = 0.75; // of its distance: nothing stands nearer to the way
  private static final double BRIDGE_GAPS = 2.0; // gaps of paint, one after the other
  private static final double BEHIND_M = 6.0; // way that stays open for backing out of places
  private static final long HELD_UP_MICROS = 25 * Clock.MICROS_PER_SECOND;
  private static final double HOLE_M = 1.5; // longest step along an inferred side

  /** A line to look for, and whether it is certain. */
  record Known(List<Point> line, boolean sure) {}

  /**
   * A side where no certain line is.
   *
   * @param atVehicle whether it leads to where the vehicle is now, and may go on from there
   */
  record Inferred(List<Point> points, boolean atVehicle) {}

  private final List<LanePlace> places = new ArrayList<>();
  private int now = -1; // index of the place where the vehicle is
  private long addedMicros; // when it came to the newest place

  void clear() {
    places.clear();
    now = -1;
  }

  /** The vehicle is there at a time [µs]. */
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

  /** Whether the vehicle has not come to a new place for long. */
  boolean isHeldUp(long micros) {
    return micros - addedMicros > HELD_UP_MICROS;
  }

  /**
   * From side to side across the lane that the vehicle has come from; empty if it was in none, or
   * has gone back beyond. As of the last {@link #sides}.
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

  /**
   * The sides of the lane where no certain line is.
   *
   * @param known what is known of lines
   */
  List<Inferred> sides(List<Known> known, LineGaps.Reach reach) {
    int from = Math.max(0, places.size() - LOOKED_AT);
    follow(from, known, reach);
    bridge(from, reach);
    List<Inferred> sides = new ArrayList<>();
    side(1.0, sides);
    side(-1.0, sides);
    return sides;
  }

  /** Looks for the lines beside the newest places, and follows the lane where one is missing. */
  private void follow(int from, List<Known> known, LineGaps.Reach reach) {
    LanePlace earlier = from > 0 ? places.get(from - 1) : null;
    double widthM = // of the lane; NaN: the vehicle is in none
        earlier == null ? Double.NaN : earlier.left.awayM + earlier.right.awayM;
    double missedM = 0.0; // since both lines were seen
    double blindM = 0.0; // since any was seen
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
    double[] along = direction(i);
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

  /** Between two places where both lines are known the lane changes evenly. */
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

  /** Strings one side (1: left) where no certain line is. */
  private void side(double sign, List<Inferred> sides) {
    List<Point> string = new ArrayList<>();
    for (int i = 0; i < places.size(); i++) {
      LanePlace place = places.get(i);
      LanePlace.Side side = place.side(sign);
      boolean isSide = !Double.isNaN(side.awayM) && !side.sure;
      Point at = isSide ? beside(i, sign * side.awayM) : place.at;
      isSide &= isClear(i, at, side.awayM);
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

  private Point beside(int i, double leftM) {
    double[] along = direction(i);
    Point at = places.get(i).at;
    return Point.of(at.x() - leftM * along[1], at.y() + leftM * along[0], 0.0);
  }

  private static void add(List<Point> string, boolean atVehicle, List<Inferred> sides) {
    if (string.size() > 1) {
      sides.add(new Inferred(string, atVehicle));
    }
  }

  /** Whether a side lies beside all of the way there, not across it as in a tight turn. */
  private boolean isClear(int i, Point side, double awayM) {
    int span = (int) Math.ceil(2.0 * awayM / STEP_M);
    for (int k = Math.max(0, i - span); k < Math.min(places.size(), i + span); k++) {
      if (LineGeometry.metres(side, places.get(k).at) < OWN_SHARE * awayM) {
        return false;
      }
    }
    return true;
  }

  /** Direction of the way at a place, as a unit vector. */
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
