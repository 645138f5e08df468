package org.u2sa.core.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.u2sa.messages.frame.Point;

/** Beads strung to lines, and what is missing between their ends. Metres from the map's anchor. */
final class LineChains {
  private static final double LINK_M = 0.5; // longest step from bead to bead
  private static final double ASIDE = 0.7; // sine of the angle by which a step may leave the line
  private static final double SHORTEST_M = 0.5; // what is shorter is no line
  private static final double TANGENT_M = 0.8; // of an end: over which its direction is measured
  private static final double FACING = Math.cos(Math.toRadians(50.0));
  private static final double CURVE_STEP_M = 0.3;
  private static final double VIEWS = 2.5; // places on average from which a sure line was seen
  private static final double BESIDE_STEP_M = 0.1;
  private static final double SQUARE = 0.9; // sine of the least angle between lane and its width
  private static final double KNOWN =
      0.7; // share of the ground beyond an end that must be looked at
  private static final int LANE_POINTS = 60; // 9 m before its end say which lane a line belongs to
  private static final int LANE_STEP = 4;
  private static final int LANE_PLACES = 4; // so many steps, 2.4 m, make it the driven lane
  private static final double BESIDE_M = 0.4; // an end so near to a longer line is a part of that

  private final List<List<Point>> lines;
  private final Set<List<Point>> sure;
  private final double laneWidthM;

  /** An end of a line, and where it points to. */
  private record End(List<Point> line, Point at, Point before, double dx, double dy) {}

  /**
   * How far what is not seen is taken to go.
   *
   * @param gapM longest gap between two ends [m]
   * @param aloneM beyond an end [m]
   * @param besideM beyond an end, beside the other line of its lane [m]
   * @param widestM such a lane [m]
   */
  record Reach(double gapM, double aloneM, double besideM, double widestM) {}

  private record Join(End one, End other, double cost) {}

  /** What goes on beside another line, and whether the vehicle has driven between the two. */
  private record Beside(List<Point> points, boolean driven) {}

  private LineChains(List<List<Point>> lines, Set<List<Point>> sure, double laneWidthM) {
    this.lines = lines;
    this.sure = sure;
    this.laneWidthM = laneWidthM;
  }

  static LineChains of(List<LineBeads.Bead> beads, double laneWidthM) {
    int[][] next = new int[beads.size()][];
    Neighbours near = new Neighbours(beads);
    for (int i = 0; i < next.length; i++) {
      next[i] = new int[] {near.step(i, 1.0), near.step(i, -1.0)};
    }
    boolean[] strung = new boolean[next.length];
    List<List<Point>> lines = new ArrayList<>();
    Set<List<Point>> sure = new HashSet<>();
    for (int i = 0; i < next.length; i++) {
      if (!strung[i]) {
        List<LineBeads.Bead> string = string(i, beads, next, strung);
        List<Point> line = new ArrayList<>(string.size());
        string.forEach(bead -> line.add(Point.of(bead.x, bead.y, 0.0)));
        if (lengthM(line) >= SHORTEST_M) {
          lines.add(line);
          double views = string.stream().mapToInt(bead -> bead.views).average().orElse(0.0);
          if (views >= VIEWS) {
            sure.add(line);
          }
        }
      }
    }
    return new LineChains(lines, sure, laneWidthM);
  }

  /** From a bead to both sides as far as beads name each other. */
  private static List<LineBeads.Bead> string(
      int from, List<LineBeads.Bead> beads, int[][] next, boolean[] strung) {
    List<LineBeads.Bead> line = new ArrayList<>();
    strung[from] = true;
    line.add(beads.get(from));
    for (int way = 0; way < 2; way++) {
      int before = from;
      int at = next[from][way];
      while (at >= 0 && !strung[at] && (next[at][0] == before || next[at][1] == before)) {
        strung[at] = true;
        line.add(beads.get(at));
        int on = next[at][0] == before ? next[at][1] : next[at][0];
        before = at;
        at = on;
      }
      Collections.reverse(line);
    }
    return line;
  }

  private static double lengthM(List<Point> line) {
    double length = 0.0;
    for (int i = 1; i < line.size(); i++) {
      length += metres(line.get(i - 1), line.get(i));
    }
    return length;
  }

  private static double metres(Point a, Point b) {
    double x = a.x() - b.x();
    double y = a.y() - b.y();
    return Math.sqrt(x * x + y * y); // hypot takes ten times as long
  }

  /** What was seen. */
  List<List<Point>> lines() {
    return lines;
  }

  /** Whether a line was seen from several places. */
  boolean isSure(List<Point> line) {
    return sure.contains(line);
  }

  /** Which ground was looked at. */
  interface Looked {
    boolean isKnown(double x, double y);
  }

  /** Where the vehicle has driven. */
  interface Driven {
    boolean passesBetween(Point a, Point b);
  }

  /**
   * What closes gaps between ends that face each other, and what goes on beyond other ends, but for
   * those beyond which the ground was looked at as far as gaps reach: there the line ends. A line
   * of the lane in which the vehicle drives does not end before the lane's other line: a lane is
   * open to its end, not to its sides.
   */
  List<List<Point>> gaps(Reach reach, Looked looked, Driven driven) {
    List<End> ends = new ArrayList<>();
    for (List<Point> line : lines) {
      for (End end : List.of(end(line, false), end(line, true))) {
        if (!isBesideLonger(end)) {
          ends.add(end);
        }
      }
    }
    List<Join> joins = new ArrayList<>();
    for (int i = 0; i < ends.size(); i++) {
      for (int k = i + 1; k < ends.size(); k++) {
        if (ends.get(i).line() != ends.get(k).line()) {
          join(ends.get(i), ends.get(k), reach.gapM(), joins);
        }
      }
    }
    joins.sort(Comparator.comparingDouble(Join::cost)); // stable
    List<List<Point>> gaps = new ArrayList<>();
    for (Join join : joins) {
      if (ends.contains(join.one) && ends.contains(join.other)) {
        ends.remove(join.one);
        ends.remove(join.other);
        gaps.add(curve(join.one, join.other));
      }
    }
    for (End end : ends) {
      Beside beside = beside(end, reach, driven);
      List<Point> extension = beside.points();
      boolean leadsFar = lengthM(extension) >= reach.gapM();
      boolean inLane = beside.driven() && lengthM(extension) >= reach.aloneM();
      if (!inLane
          && isKnown(leadsFar ? extension : extension(end, reach.gapM()), reach.gapM(), looked)) {
        continue;
      }
      if (extension.size() < 2 || lengthM(extension) < reach.aloneM()) {
        extension = extension(end, reach.aloneM());
      }
      if (extension.size() > 1) {
        gaps.add(extension);
      }
    }
    return gaps;
  }

  /** Whether the ground where a line would go on was looked at, farther than gaps are long. */
  private static boolean isKnown(List<Point> line, double gapM, Looked looked) {
    int known = 0;
    int places = 0;
    double gone = 0.0;
    for (int i = 1; i < line.size() && gone < gapM; i++) {
      gone += metres(line.get(i - 1), line.get(i));
      known += looked.isKnown(line.get(i).x(), line.get(i).y()) ? 1 : 0;
      places++;
    }
    return places > 0 && gone >= KNOWN * gapM && known >= KNOWN * places;
  }

  /** Whether an end belongs to another line, seen twice in slightly different places. */
  private boolean isBesideLonger(End end) {
    for (List<Point> line : lines) {
      boolean longer = line != end.line() && line.size() > end.line().size();
      for (int i = 0; longer && i < line.size(); i++) {
        if (metres(end.at(), line.get(i)) < BESIDE_M) {
          return true;
        }
      }
    }
    return false;
  }

  private static End end(List<Point> line, boolean last) {
    int at = last ? line.size() - 1 : 0;
    int step = last ? -1 : 1;
    int inner = at;
    double gone = 0.0;
    while (gone < TANGENT_M && inner + step >= 0 && inner + step < line.size()) {
      gone += metres(line.get(inner), line.get(inner + step));
      inner += step;
    }
    Point end = line.get(at);
    Point before = line.get(inner);
    double length = Math.max(1.0e-9, metres(end, before));
    return new End(
        line, end, before, (end.x() - before.x()) / length, (end.y() - before.y()) / length);
  }

  private static void join(End a, End b, double longestM, List<Join> joins) {
    double gap = metres(a.at(), b.at());
    if (gap > longestM) {
      return;
    }
    double x = (b.at().x() - a.at().x()) / Math.max(1.0e-9, gap);
    double y = (b.at().y() - a.at().y()) / Math.max(1.0e-9, gap);
    double fromA = x * a.dx() + y * a.dy();
    double fromB = -x * b.dx() - y * b.dy();
    boolean near = gap < LINK_M;
    if (near ? fromA > -ASIDE && fromB > -ASIDE : fromA > FACING && fromB > FACING) {
      joins.add(new Join(a, b, gap * (1.0 + 4.0 * (2.0 - fromA - fromB))));
    }
  }

  /** A cubic Hermite curve that leaves one end and arrives at the other as they point. */
  private static List<Point> curve(End a, End b) {
    double gap = metres(a.at(), b.at());
    int steps = Math.max(1, (int) Math.ceil(gap / CURVE_STEP_M));
    List<Point> points = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double t = (double) i / steps;
      double h10 = t * (1.0 - t) * (1.0 - t) * gap;
      double h11 = t * t * (t - 1.0) * gap;
      double h01 = t * t * (3.0 - 2.0 * t);
      points.add(
          Point.of(
              a.at().x() + h01 * (b.at().x() - a.at().x()) + h10 * a.dx() - h11 * b.dx(),
              a.at().y() + h01 * (b.at().y() - a.at().y()) + h10 * a.dy() - h11 * b.dy(),
              0.0));
    }
    return points;
  }

  /** On with the curvature that the end has, until another line is near. */
  private List<Point> extension(End end, double lengthM) {
    List<Point> points = new ArrayList<>(List.of(end.at()));
    double bend = bend(end);
    double heading = Math.atan2(end.dy(), end.dx()) + 0.5 * bend * TANGENT_M;
    Point at = end.at();
    for (double gone = 0.0; gone < lengthM - 1.0e-9; gone += CURVE_STEP_M) {
      double step = Math.min(CURVE_STEP_M, lengthM - gone);
      heading += bend * step;
      at = Point.of(at.x() + step * Math.cos(heading), at.y() + step * Math.sin(heading), 0.0);
      if (isNear(at, end.line(), end.line())) {
        break;
      }
      points.add(at);
    }
    return points;
  }

  /**
   * On beside the other line of the lane, as far away as at the end: a lane keeps its width. Of two
   * lines, to the left and to the right, the one of the lane that was driven, else the one that
   * leads farther.
   */
  private Beside beside(End end, Reach reach, Driven driven) {
    Beside best = new Beside(List.of(), false);
    if (reach.besideM() > reach.aloneM()) {
      for (List<Point> other : lines) {
        if (other != end.line()) {
          List<Point> found = beside(end, other, reach);
          boolean isOwn = found.size() > 1 && isBetween(end, other, reach.widestM(), driven);
          boolean farther = lengthM(found) > lengthM(best.points());
          if (isOwn == best.driven() ? farther : isOwn) {
            best = new Beside(found, isOwn);
          }
        }
      }
    }
    return best;
  }

  /**
   * Whether the vehicle has driven between the last part of a line and another line, along a lane
   * of both: who passes an end on another way, as in no-man's land, was not in their lane.
   */
  private boolean isBetween(End end, List<Point> other, double widestM, Driven driven) {
    List<Point> line = end.line();
    boolean last = end.at() == line.get(line.size() - 1);
    int passed = 0;
    for (int back = 0; back < Math.min(line.size(), LANE_POINTS); back += LANE_STEP) {
      int at = last ? line.size() - 1 - back : back;
      Point from = line.get(at);
      int beside = nearest(from, other);
      double wide = metres(from, other.get(beside));
      double[] way = way(line, at);
      double[] besideWay = way(other, beside);
      boolean isLane =
          wide >= laneWidthM
              && wide <= widestM
              && Math.abs(way[0] * besideWay[0] + way[1] * besideWay[1]) > FACING;
      passed += isLane && driven.passesBetween(from, other.get(beside)) ? 1 : 0;
    }
    return passed >= LANE_PLACES;
  }

  private static int nearest(Point place, List<Point> line) {
    int nearest = 0;
    for (int i = 1; i < line.size(); i++) {
      nearest = metres(place, line.get(i)) < metres(place, line.get(nearest)) ? i : nearest;
    }
    return nearest;
  }

  private List<Point> beside(End end, List<Point> other, Reach reach) {
    int nearest = nearest(end.at(), other);
    double wide = metres(end.at(), other.get(nearest));
    double[] way = way(other, nearest);
    double sense = way[0] * end.dx() + way[1] * end.dy();
    double aside = way[0] * (end.at().y() - other.get(nearest).y());
    aside -= way[1] * (end.at().x() - other.get(nearest).x());
    boolean isLane =
        wide >= laneWidthM
            && wide <= reach.widestM()
            && Math.abs(sense) > FACING
            && Math.abs(aside) > SQUARE * wide;
    List<Point> points = new ArrayList<>();
    if (!isLane) {
      return points;
    }
    points.add(end.at());
    int step = sense > 0.0 ? 1 : -1;
    double left = Math.copySign(wide, aside);
    double gone = 0.0;
    for (int i = nearest + step; i >= 0 && i < other.size() && gone < reach.besideM(); i += step) {
      double[] on = way(other, i);
      Point at = Point.of(other.get(i).x() - left * on[1], other.get(i).y() + left * on[0], 0.0);
      Point last = points.get(points.size() - 1);
      double ahead = (at.x() - last.x()) * on[0] + (at.y() - last.y()) * on[1];
      if (step * ahead < BESIDE_STEP_M) {
        continue; // in the inside of a bend, or not yet beyond the end
      }
      if (isNear(at, end.line(), other)) {
        break;
      }
      gone += metres(last, at);
      points.add(at);
    }
    return points;
  }

  /** Which way a line runs at one of its points, as a unit vector. */
  private static double[] way(List<Point> line, int at) {
    int span = (int) Math.round(TANGENT_M / LineBeads.STEP_M);
    Point from = line.get(Math.max(0, at - span));
    Point to = line.get(Math.min(line.size() - 1, at + span));
    double length = Math.max(1.0e-9, metres(from, to));
    return new double[] {(to.x() - from.x()) / length, (to.y() - from.y()) / length};
  }

  /** Curvature at an end [1/m], anticlockwise positive on the way out; bounded. */
  private static double bend(End end) {
    double most = 0.5;
    int size = end.line().size();
    boolean last = end.at() == end.line().get(size - 1);
    int far = Math.min(size - 1, (int) Math.round(2.0 * TANGENT_M / LineBeads.STEP_M));
    int middle = far / 2;
    if (middle < 2) {
      return 0.0;
    }
    Point a = end.line().get(last ? size - 1 - far : far);
    Point b = end.line().get(last ? size - 1 - middle : middle);
    Point c = end.at();
    double first = Math.atan2(b.y() - a.y(), b.x() - a.x());
    double second = Math.atan2(c.y() - b.y(), c.x() - b.x());
    double turned = Math.IEEEremainder(second - first, 2.0 * Math.PI);
    double way = 0.5 * (metres(a, b) + metres(b, c));
    return Math.max(-most, Math.min(most, turned / Math.max(0.1, way)));
  }

  /** Whether a place is nearer to a line than a lane is wide, other than to these two. */
  private boolean isNear(Point at, List<Point> own, List<Point> partner) {
    for (List<Point> line : lines) {
      for (int i = 0; line != own && line != partner && i < line.size(); i++) {
        if (metres(at, line.get(i)) < laneWidthM) {
          return true;
        }
      }
    }
    return false;
  }

  /** Finds the next bead along a line. */
  private static final class Neighbours {
    private final List<LineBeads.Bead> beads;
    private final Integer[] byX;
    private final int[] rank;

    Neighbours(List<LineBeads.Bead> beads) {
      this.beads = beads;
      byX = new Integer[beads.size()];
      rank = new int[beads.size()];
      Arrays.setAll(byX, i -> i);
      Arrays.sort(byX, Comparator.comparingDouble((Integer i) -> beads.get(i).x));
      for (int i = 0; i < byX.length; i++) {
        rank[byX[i]] = i;
      }
    }

    /** The nearest bead ahead (1) or behind (-1) that may follow it; −1 if there is none. */
    int step(int from, double sign) {
      LineBeads.Bead bead = beads.get(from);
      int best = -1;
      double nearest = LINK_M;
      for (int way = -1; way <= 1; way += 2) {
        for (int k = rank[from] + way; k >= 0 && k < byX.length; k += way) {
          LineBeads.Bead other = beads.get(byX[k]);
          double x = other.x - bead.x;
          double y = other.y - bead.y;
          if (Math.abs(x) > nearest) {
            break;
          }
          double away = Math.hypot(x, y);
          double along = sign * (x * bead.dx + y * bead.dy);
          double across = Math.abs(x * bead.dy - y * bead.dx);
          boolean parallel = Math.abs(bead.dx * other.dx + bead.dy * other.dy) > ASIDE;
          if (parallel && along > 0.02 && across <= ASIDE * away && away < nearest) {
            best = byX[k];
            nearest = away;
          }
        }
      }
      return best;
    }
  }
}
