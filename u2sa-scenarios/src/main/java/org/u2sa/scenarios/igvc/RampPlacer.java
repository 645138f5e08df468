package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;

/**
 * Places a ramp on a finished course, on a straight and empty stretch of a lane with solid lines,
 * where {@link RampRules} allow it. Nothing else on the course changes.
 */
final class RampPlacer {
  private static final double MIN_RISE = 0.10;
  private static final double MAX_RISE = 0.15; // limit of the rules
  private static final double MIN_WAY_M = 1.9;
  private static final double MAX_WAY_M = 2.44; // a board of 8 ft
  private static final double MIN_TOP_M = 0.8;
  private static final double MAX_TOP_M = 1.4;
  private static final double ASIDE_M = 0.3; // boards beyond the lines
  private static final double AFTER_START_M = 3.0;
  private static final double STEP_M = 0.5;

  private final Centreline line;
  private final CourseBuilder builder;
  private final String name;
  private final double wayM;
  private final double topM;
  private final double heightM;

  private RampPlacer(Centreline line, CourseBuilder builder, String name, Random random) {
    this.line = line;
    this.builder = builder;
    this.name = name;
    wayM = MIN_WAY_M + (MAX_WAY_M - MIN_WAY_M) * random.nextDouble();
    topM = MIN_TOP_M + (MAX_TOP_M - MIN_TOP_M) * random.nextDouble();
    heightM = wayM * (MIN_RISE + (MAX_RISE - MIN_RISE) * random.nextDouble());
  }

  /**
   * Course with a ramp added; empty if there is no room.
   *
   * @param builder builder of the course
   */
  static Optional<Course> place(
      Course course, CourseLayout layout, CourseBuilder builder, Random random) {
    Centreline line = layout.line();
    RampPlacer placer = new RampPlacer(line, builder, course.origin(), random);
    List<Integer> places = new ArrayList<>();
    int step = line.along(0, STEP_M);
    for (int at = line.along(0, AFTER_START_M); at < layout.lanesEnd(); at += step) {
      places.add(at);
    }
    for (int at = layout.lanesBegin(); at < line.count(); at += step) {
      places.add(at);
    }
    while (!places.isEmpty()) {
      int at = places.remove(random.nextInt(places.size()));
      Course ramped = placer.with(course, at);
      if (RampRules.faults(ramped).isEmpty()) {
        return Optional.of(ramped);
      }
    }
    return Optional.empty();
  }

  private Course with(Course course, int at) {
    Point foot = line.beside(at, 0.0);
    int end = line.along(at, 2.0 * wayM + topM);
    Point far = line.beside(end, 0.0);
    double heading = StrictMath.atan2(far.y() - foot.y(), far.x() - foot.x());
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    double half = 0.0;
    for (int i = at; i <= end; i++) {
      Point middle = line.beside(i, 0.0);
      double left = (middle.y() - foot.y()) * cos - (middle.x() - foot.x()) * sin;
      half = Math.max(half, Math.abs(left) + 0.5 * line.widthM(i));
    }
    List<Point> profile = new ArrayList<>();
    double[] along = {0.0, wayM, wayM + topM, 2.0 * wayM + topM};
    for (int i = 0; i < along.length; i++) {
      double up = i == 0 || i == along.length - 1 ? 0.0 : heightM;
      profile.add(Point.of(foot.x() + along[i] * cos, foot.y() + along[i] * sin, up));
    }
    List<ObjectDescription> objects = new ArrayList<>(course.objects());
    objects.add(builder.ramp(profile, 2.0 * (half + ASIDE_M)));
    return new Course(name, objects);
  }
}
