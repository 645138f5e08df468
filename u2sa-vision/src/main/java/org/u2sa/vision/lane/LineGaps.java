package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Bridges gaps between line ends and extends lines beyond them. Coordinates in metres from the
 * map's anchor.
 */
final class LineGaps {
  private static final double NEAR_M = 0.5; // closer ends are not a gap
  private static final double ASIDE = 0.7;
  private static final double FACING = Math.cos(Math.toRadians(50.0));
  private static final double KNOWN = 0.7; // required fraction of observed ground beyond an end
  private static final double BESIDE_M = 0.4; // an end this close to a longer line is part of it

  private final List<List<Point>> lines;
  private final Reach reach;
  private final Looked looked;
  private final LanePartner partner;
  private final List<Joint> joined = new ArrayList<>();
  private final List<Extension> extended = new ArrayList<>();
  private final JoinedLines strings;

  /**
   * Limits of inferred lines.
   *
   * @param gapM longest gap between two ends [m]
   * @param aloneM extension beyond an end [m]
   * @param besideM extension beyond an end, beside the other line of its lane [m]
   * @param narrowestM narrowest lane [m]
   * @param widestM widest lane [m]
   */
  record Reach(double gapM, double aloneM, double besideM, double narrowestM, double widestM) {
    boolean isLane(double widthM) {
      return widthM >= narrowestM && widthM <= widestM;
    }
  }

  interface Looked {
    boolean isKnown(double x, double y);
  }

  interface Driven {
    boolean passesBetween(Point a, Point b);
  }

  /** A closed gap, and the lines to either side of it. */
  record Joint(List<Point> points, List<Point> one, List<Point> other) {}

  /** Continuation of a line beyond one of its ends. */
  record Extension(List<Point> points, List<Point> line) {}

  private record Join(LineEnd one, LineEnd other, double cost) {}

  /**
   * Closes gaps between ends that face each other and extends lines beyond other ends, except where
   * the ground beyond was observed up to the gap length: there the line ends. A line of the
   * vehicle's own lane does not end before the lane's other line does, because a lane is open at
   * its end but not at its sides.
   */
  LineGaps(List<List<Point>> lines, Reach reach, Looked looked, Driven driven) {
    this.lines = lines;
    this.reach = reach;
    this.looked = looked;
    List<LineEnd> ends = new ArrayList<>();
    for (List<Point> line : lines) {
      for (LineEnd end : List.of(LineEnd.first(line), LineEnd.last(line))) {
        if (!isBesideLonger(end)) {
          ends.add(end);
        }
      }
    }
    strings = new JoinedLines(lines);
    join(ends);
    partner = new LanePartner(strings.all, reach, driven);
    ends.forEach(this::extend);
  }

  List<Joint> joined() {
    return joined;
  }

  /** Continuations of lines beyond an end. */
  List<Extension> extended() {
    return extended;
  }

  /** Continuation of an inferred lane side beyond its last point, at the vehicle. */
  List<Point> onward(List<Point> side, Point vehicle) {
    return partner.onward(LineEnd.last(side), vehicle);
  }

  /**
   * Whether points run parallel to another line at a lane's width, and are therefore a lane side
   * rather than a line across it.
   *
   * @param line line they belong to
   */
  boolean isLaneSide(List<Point> points, List<Point> line) {
    return partner.isBesideOther(points, strings.with(line));
  }

  /** Joins ends that face each other, best pairs first, and removes them from the list. */
  private void join(List<LineEnd> ends) {
    List<Join> joins = new ArrayList<>();
    for (int i = 0; i < ends.size(); i++) {
      for (int k = i + 1; k < ends.size(); k++) {
        if (ends.get(i).line() != ends.get(k).line()) {
          join(ends.get(i), ends.get(k), joins);
        }
      }
    }
    joins.sort(Comparator.comparingDouble(Join::cost)); // stable
    for (Join join : joins) {
      if (ends.contains(join.one) && ends.contains(join.other)) {
        ends.remove(join.one);
        ends.remove(join.other);
        List<Point> curve = join.one.curveTo(join.other);
        joined.add(new Joint(curve, join.one.line(), join.other.line()));
        strings.join(join.one, curve, join.other);
      }
    }
  }

  private void join(LineEnd a, LineEnd b, List<Join> joins) {
    double gap = LineGeometry.metres(a.at(), b.at());
    if (gap > reach.gapM()) {
      return;
    }
    double x = (b.at().x() - a.at().x()) / Math.max(1.0e-9, gap);
    double y = (b.at().y() - a.at().y()) / Math.max(1.0e-9, gap);
    double fromA = x * a.dx() + y * a.dy();
    double fromB = -x * b.dx() - y * b.dy();
    boolean near = gap < NEAR_M;
    if (near ? fromA > -ASIDE && fromB > -ASIDE : fromA > FACING && fromB > FACING) {
      joins.add(new Join(a, b, gap * (1.0 + 4.0 * (2.0 - fromA - fromB))));
    }
  }

  private void extend(LineEnd part) {
    LineEnd end = part.of(strings.with(part.line()));
    LanePartner.Beside beside = partner.beside(end);
    List<Point> extension = beside.points();
    boolean leadsFar = LineGeometry.lengthM(extension) >= reach.gapM();
    boolean inLane = beside.driven() && LineGeometry.lengthM(extension) >= reach.aloneM();
    if (!inLane && isKnown(leadsFar ? extension : alone(end, reach.gapM()))) {
      return;
    }
    if (extension.size() < 2 || LineGeometry.lengthM(extension) < reach.aloneM()) {
      extension = alone(end, reach.aloneM());
    }
    if (extension.size() > 1) {
      extended.add(new Extension(extension, part.line()));
    }
  }

  private List<Point> alone(LineEnd end, double lengthM) {
    return end.extension(
        lengthM, (from, to) -> partner.approachesOther(from, to, end.line(), end.line()));
  }

  /** Whether the ground along an extension was observed for at least about the gap length. */
  private boolean isKnown(List<Point> line) {
    int known = 0;
    int places = 0;
    double gone = 0.0;
    for (int i = 1; i < line.size() && gone < reach.gapM(); i++) {
      gone += LineGeometry.metres(line.get(i - 1), line.get(i));
      known += looked.isKnown(line.get(i).x(), line.get(i).y()) ? 1 : 0;
      places++;
    }
    return places > 0 && gone >= KNOWN * reach.gapM() && known >= KNOWN * places;
  }

  /** Whether an end belongs to a longer line that was seen twice, slightly offset. */
  private boolean isBesideLonger(LineEnd end) {
    for (List<Point> line : lines) {
      boolean longer = line != end.line() && line.size() > end.line().size();
      for (int i = 0; longer && i < line.size(); i++) {
        if (LineGeometry.isWithin(BESIDE_M, end.at(), line.get(i))) {
          return true;
        }
      }
    }
    return false;
  }

  /** Merges lines whose gaps were closed: dashes and remains of worn paint. */
  static final class JoinedLines {
    private final List<List<Point>> all = new ArrayList<>();
    private final List<List<Point>> parts;
    private final List<List<Point>> with; // joined line of each part

    JoinedLines(List<List<Point>> lines) {
      parts = lines;
      with = new ArrayList<>(lines);
      all.addAll(lines);
    }

    /** Joins two lines with a curve between two of their ends. */
    void join(LineEnd one, List<Point> curve, LineEnd other) {
      List<Point> first = with(one.line());
      List<Point> second = with(other.line());
      if (first == second) {
        return; // closing a ring does not extend the line
      }
      List<Point> joined = new ArrayList<>(first);
      if (joined.get(0) == one.at()) {
        Collections.reverse(joined);
      }
      joined.addAll(curve.subList(1, Math.max(1, curve.size() - 1)));
      List<Point> rest = new ArrayList<>(second);
      if (rest.get(0) != other.at()) {
        Collections.reverse(rest);
      }
      joined.addAll(rest);
      all.removeIf(line -> line == first || line == second);
      all.add(joined);
      with.replaceAll(line -> line == first || line == second ? joined : line);
    }

    /** Joined line that contains this line. */
    List<Point> with(List<Point> line) {
      int part = 0;
      while (parts.get(part) != line) {
        part++;
      }
      return with.get(part);
    }
  }
}
