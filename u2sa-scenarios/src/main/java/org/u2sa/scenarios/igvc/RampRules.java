package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.world.Ramp;

/**
 * Checks a course's ramps against the rules: up to 15 % steep, at least 8 ft wide, crossed straight
 * by both lines of one lane, which are solid, with nothing else on it or just before it.
 */
final class RampRules {
  private static final double STEEPEST = 0.15;
  private static final double ROUNDING = 1.0e-3;
  private static final double MIN_WIDTH_M = 2.438; // 8 ft
  private static final double BEFORE_M = 1.5; // straight and free before each foot
  private static final double STRAIGHT = 0.12; // tolerance between line and ramp direction [rad]
  private static final double PAINT_M = 0.1; // distance from a boundary to its paint
  private static final double STEP_M = 0.1;

  private final Course course;
  private final Ramp ramp;
  private final String uid;
  private final List<String> faults = new ArrayList<>();

  private RampRules(Course course, Course.NamedRamp placed) {
    this.course = course;
    ramp = placed.ramp();
    uid = placed.uid();
  }

  /** Rule violations of a course's ramps, one sentence each. */
  static List<String> faults(Course course) {
    List<String> all = new ArrayList<>();
    for (Course.NamedRamp placed : course.ramps()) {
      RampRules rules = new RampRules(course, placed);
      rules.look();
      all.addAll(rules.faults);
    }
    return all;
  }

  private void fault(String format, Object... values) {
    faults.add(uid + String.format(Locale.ROOT, format, values));
  }

  private void look() {
    if (ramp.steepest() > STEEPEST + ROUNDING) {
      fault(" rises by %.3f m per metre", ramp.steepest());
    }
    if (ramp.widthM() < MIN_WIDTH_M) {
      fault(" is %.2f m wide", ramp.widthM());
    }
    for (ObjectDescription object : course.objects()) {
      boolean isSpot = !(object instanceof PolyLine) && !object.objectType().equals(Course.START);
      if (isSpot && isNear(object.center(), 0.5)) {
        fault(" has %s on or beside it", object.uid());
      }
    }
    Course.Start start = course.start();
    if (isNear(Point.of(start.eastM(), start.northM(), 0.0), 0.0)) {
      fault(" begins at the start");
    }
    int over = 0;
    for (PolyLine line : course.boundaries()) {
      over += leadsOver(line) ? 1 : 0;
    }
    if (over != 2) {
      fault(" has %d lines across it", over);
    }
    for (ObjectDescription end : course.of(Course.END)) {
      if (((PolyLine) end).points().stream().anyMatch(point -> isNear(point, 0.0))) {
        fault(" is at the course's end");
      }
    }
  }

  private boolean isNear(Point at, double asideM) {
    double along = ramp.along(at.x(), at.y());
    return along > -BEFORE_M
        && along < ramp.lengthM() + BEFORE_M
        && Math.abs(ramp.left(at.x(), at.y())) < 0.5 * ramp.widthM() + asideM;
  }

  /** Whether a boundary crosses both feet; touching the ramp in any other way is a fault. */
  private boolean leadsOver(PolyLine line) {
    double first = Double.POSITIVE_INFINITY;
    double last = Double.NEGATIVE_INFINITY;
    for (int i = 1; i < line.points().size(); i++) {
      Point a = line.points().get(i - 1);
      Point b = line.points().get(i);
      int steps = 1 + (int) (Math.hypot(b.x() - a.x(), b.y() - a.y()) / STEP_M);
      for (int k = 0; k <= steps; k++) {
        double share = (double) k / steps;
        Point at = Point.of(a.x() + share * (b.x() - a.x()), a.y() + share * (b.y() - a.y()), 0.0);
        if (!isNear(at, 0.2)) {
          continue;
        }
        double along = ramp.along(at.x(), at.y());
        first = Math.min(first, along);
        last = Math.max(last, along);
        double gone = ramp.along(b.x(), b.y()) - ramp.along(a.x(), a.y());
        double aside = ramp.left(b.x(), b.y()) - ramp.left(a.x(), a.y());
        if (Math.abs(aside) > Math.tan(STRAIGHT) * Math.abs(gone)) {
          fault(" is not along %s", line.uid());
          return false;
        }
        if (Math.abs(ramp.left(at.x(), at.y())) > 0.5 * ramp.widthM()) {
          fault(" ends beside %s", line.uid());
          return false;
        }
        if (!isPainted(at)) {
          fault(" is where %s has no paint", line.uid());
          return false;
        }
      }
    }
    return first < 0.0 && last > ramp.lengthM();
  }

  private boolean isPainted(Point at) {
    for (ObjectDescription object : course.objects()) {
      String type = object.objectType();
      if (type.equals(Scenery.LINE) || type.equals(Scenery.WORN_LINE)) {
        List<Point> points = ((PolyLine) object).points();
        for (int i = 1; i < points.size(); i++) {
          if (at.flatDistanceTo(points.get(i - 1), points.get(i)) < PAINT_M) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
