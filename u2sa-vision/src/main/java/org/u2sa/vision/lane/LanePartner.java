package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.u2sa.messages.frame.Point;

/**
 * Extends a line parallel to the other line of its lane, because a lane keeps its width.
 * Coordinates in metres from the map's anchor.
 */
record LanePartner(List<List<Point>> lines, LineGaps.Reach reach, LineGaps.Driven driven) {
  private static final double FACING = Math.cos(Math.toRadians(50.0));
  private static final double PARALLEL = Math.cos(Math.toRadians(30.0));
  private static final double SHARE_BESIDE = 0.6; // fraction of a lane side's points
  private static final double STEP_M = 0.1;
  private static final double SQUARE = 0.9; // sine of the minimum angle between lane and its width
  private static final double MEETING_WIDTHS = 1.5; // search distance, in narrowest lane widths
  private static final int LANE_POINTS = 60; // the last 9 m determine a line's lane
  private static final int LANE_STEP = 4;
  private static final int LANE_PLACES = 4; // minimum steps (2.4 m) of the driven lane

  /** A continuation beside another line, and whether the vehicle has driven between the two. */
  record Beside(List<Point> points, boolean driven) {}

  /**
   * Extends a line parallel to the lane's other line, at the distance of its end. Of two
   * candidates, left and right, prefers the one of the driven lane, then the longer one.
   */
  Beside beside(LineEnd end) {
    Beside best = new Beside(List.of(), false);
    if (reach.besideM() > reach.aloneM()) {
      for (List<Point> other : lines) {
        if (other != end.line()) {
          List<Point> found = beside(end, other);
          boolean isOwn = found.size() > 1 && isBetween(end, other);
          boolean farther = LineGeometry.lengthM(found) > LineGeometry.lengthM(best.points());
          if (isOwn == best.driven() ? farther : isOwn) {
            best = new Beside(found, isOwn);
          }
        }
      }
    }
    return best;
  }

  /** Continuation of an inferred side of the vehicle's lane, beside the lane's other line. */
  List<Point> onward(LineEnd end, Point vehicle) {
    List<Point> best = List.of();
    for (List<Point> other : lines) {
      Point across = other.get(LineGeometry.nearest(end.at(), other));
      double toward =
          (across.x() - end.at().x()) * (vehicle.x() - end.at().x())
              + (across.y() - end.at().y()) * (vehicle.y() - end.at().y());
      double square =
          LineGeometry.metres(across, end.at()) * LineGeometry.metres(vehicle, end.at());
      List<Point> found = toward > FACING * square ? beside(end, other) : List.of();
      best = LineGeometry.lengthM(found) > LineGeometry.lengthM(best) ? found : best;
    }
    return best;
  }

  /**
   * Whether the vehicle has driven between the last part of a line and another line, along their
   * common lane. Passing an end on a different path, as in no-man's land, does not count.
   */
  private boolean isBetween(LineEnd end, List<Point> other) {
    List<Point> line = end.line();
    int passed = 0;
    for (int back = 0; back < Math.min(line.size(), LANE_POINTS); back += LANE_STEP) {
      int at = end.index(back);
      Point from = line.get(at);
      int beside = LineGeometry.nearest(from, other);
      double[] way = LineGeometry.direction(line, at);
      double[] besideWay = LineGeometry.direction(other, beside);
      boolean isLane =
          reach.isLane(LineGeometry.metres(from, other.get(beside)))
              && Math.abs(way[0] * besideWay[0] + way[1] * besideWay[1]) > FACING;
      passed += isLane && driven.passesBetween(from, other.get(beside)) ? 1 : 0;
    }
    return passed >= LANE_PLACES;
  }

  private List<Point> beside(LineEnd end, List<Point> other) {
    int nearest = LineGeometry.nearest(end.at(), other);
    double wide = LineGeometry.metres(end.at(), other.get(nearest));
    double[] way = LineGeometry.direction(other, nearest);
    double sense = way[0] * end.dx() + way[1] * end.dy();
    double aside = LineGeometry.leftM(end.at(), other, nearest);
    List<Point> points = new ArrayList<>();
    if (!reach.isLane(wide) || Math.abs(sense) <= FACING || Math.abs(aside) <= SQUARE * wide) {
      return points;
    }
    points.add(end.at());
    int step = sense > 0.0 ? 1 : -1;
    double left = Math.copySign(wide, aside);
    double gone = 0.0;
    for (int i = nearest + step; i >= 0 && i < other.size() && gone < reach.besideM(); i += step) {
      double[] on = LineGeometry.direction(other, i);
      Point at = Point.of(other.get(i).x() - left * on[1], other.get(i).y() + left * on[0], 0.0);
      Point last = points.get(points.size() - 1);
      double ahead = (at.x() - last.x()) * on[0] + (at.y() - last.y()) * on[1];
      if (step * ahead < STEP_M) {
        continue; // on the inside of a bend, or not yet past the end
      }
      if (approachesOther(last, at, end.line(), other)) {
        meeting(last, at, end.line(), other, left).ifPresent(points::add);
        break;
      }
      gone += LineGeometry.metres(last, at);
      points.add(at);
    }
    return points;
  }

  /**
   * Point at which the same side of the lane resumes: the nearest line end ahead on that side of
   * the other line.
   */
  private Optional<Point> meeting(
      Point from, Point to, List<Point> own, List<Point> other, double left) {
    return lines.stream()
        .filter(line -> line != own && line != other)
        .flatMap(line -> Stream.of(line.get(0), line.get(line.size() - 1)))
        .filter(at -> LineGeometry.metres(from, at) < MEETING_WIDTHS * reach.narrowestM())
        .filter(at -> isAhead(from, to, at))
        .filter(at -> reach.isLane(Math.signum(left) * asideM(at, other)))
        .min(Comparator.comparingDouble(at -> LineGeometry.metres(from, at)));
  }

  private static boolean isAhead(Point from, Point to, Point place) {
    return LineGeometry.metres(to, place) < LineGeometry.metres(from, place);
  }

  /** Whether most points have a parallel line beside them at a lane's width. */
  boolean isBesideOther(List<Point> points, List<Point> own) {
    for (List<Point> other : lines) {
      int beside = 0;
      for (int i = 0; other != own && i < points.size(); i++) {
        int nearest = LineGeometry.nearest(points.get(i), other);
        double wide = LineGeometry.metres(points.get(i), other.get(nearest));
        double[] way = LineGeometry.direction(points, i);
        double[] otherWay = LineGeometry.direction(other, nearest);
        boolean parallel = Math.abs(way[0] * otherWay[0] + way[1] * otherWay[1]) > PARALLEL;
        double aside = LineGeometry.leftM(points.get(i), other, nearest);
        boolean square = Math.abs(aside) > SQUARE * wide;
        beside += reach.isLane(wide) && parallel && square ? 1 : 0;
      }
      if (beside > SHARE_BESIDE * points.size()) {
        return true;
      }
    }
    return false;
  }

  private static double asideM(Point place, List<Point> line) {
    return LineGeometry.leftM(place, line, LineGeometry.nearest(place, line));
  }

  /**
   * Whether a step comes closer than the narrowest lane width to a line other than these two. A
   * line left behind is none to stop at: it may be the same one, seen before the position jumped.
   */
  boolean approachesOther(Point from, Point to, List<Point> own, List<Point> other) {
    for (List<Point> line : lines) {
      for (int i = 0; line != own && line != other && i < line.size(); i++) {
        Point at = line.get(i);
        if (LineGeometry.isWithin(reach.narrowestM(), to, at) && isAhead(from, to, at)) {
          return true;
        }
      }
    }
    return false;
  }
}
