package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** What is missing between the ends of lines, and beyond them. Metres from the map's anchor. */
final class LineGaps {
  private static final double NEAR_M = 0.5; // ends so near to each other are not a gap
  private static final double ASIDE = 0.7;
  private static final double FACING = Math.cos(Math.toRadians(50.0));
  private static final double KNOWN = 0.7; // share of the ground beyond an end to be looked at
  private static final double BESIDE_M = 0.4; // an end so near to a longer line is a part of that

  private final List<List<Point>> lines;
  private final Reach reach;
  private final Looked looked;
  private final LanePartner partner;
  private final List<Joint> joined = new ArrayList<>();
  private final List<Extension> extended = new ArrayList<>();
  private final JoinedLines strings;

  /**
   * How far what is not seen is taken to go.
   *
   * @param gapM longest gap between two ends [m]
   * @param aloneM beyond an end [m]
   * @param besideM beyond an end, beside the other line of its lane [m]
   * @param narrowestM narrowest lane [m]
   * @param widestM widest lane [m]
   */
  record Reach(double gapM, double aloneM, double besideM, double narrowestM, double widestM) {
    /** Whether a lane may be this wide. */
    boolean isLane(double widthM) {
      return widthM >= narrowestM && widthM <= widestM;
    }
  }

  /** Which ground was looked at. */
  interface Looked {
    boolean isKnown(double x, double y);
  }

  /** Where the vehicle has driven. */
  interface Driven {
    boolean passesBetween(Point a, Point b);
  }

  /** A closed gap, and the lines to either side of it. */
  record Joint(List<Point> points, List<Point> one, List<Point> other) {}

  /** How a line goes on beyond an end of it. */
  record Extension(List<Point> points, List<Point> line) {}

  private record Join(LineEnd one, LineEnd other, double cost) {}

  /**
   * Closes gaps between ends that face each other, and continues lines beyond other ends, but for
   * those beyond which the ground was looked at as far as gaps reach: there the line ends. A line
   * of the lane in which the vehicle drives does not end before the lane's other line: a lane is
   * open to its end, not to its sides.
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
    partner = new LanePartner(strings.all(), reach, driven);
    ends.forEach(this::extend);
  }

  /** Closed gaps between two ends. */
  List<Joint> joined() {
    return joined;
  }

  /** Continuations of lines beyond an end. */
  List<Extension> extended() {
    return extended;
  }

  /** How an inferred side of the lane goes on beyond its last point, where the vehicle is. */
  List<Point> onward(List<Point> side, Point vehicle) {
    return partner.onward(LineEnd.last(side), vehicle);
  }

  /**
   * Whether points run beside another line as far away as a lane is wide: then they are a side of a
   * lane, and do not lie across it.
   *
   * @param line which they belong to
   */
  boolean isLaneSide(List<Point> points, List<Point> line) {
    return partner.isBesideOther(points, strings.with(line));
  }

  /** Joins ends that face each other, the best pairs first, and removes them from the list. */
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
    return end.extension(lengthM, at -> partner.isNearOther(at, end.line(), end.line()));
  }

  /** Whether the ground where a line would go on was looked at, farther than gaps are long. */
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

  /** Whether an end belongs to another line, seen twice in slightly different places. */
  private boolean isBesideLonger(LineEnd end) {
    for (List<Point> line : lines) {
      boolean longer = line != end.line() && line.size() > end.line().size();
      for (int i = 0; longer && i < line.size(); i++) {
        if (LineGeometry.metres(end.at(), line.get(i)) < BESIDE_M) {
          return true;
        }
      }
    }
    return false;
  }
}
