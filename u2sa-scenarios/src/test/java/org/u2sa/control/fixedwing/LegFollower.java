package org.u2sa.control.fixedwing;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Gravity;

/**
 * The least path planner that a flight needs: a point ahead on the present leg, the next leg as
 * soon as the turn into it begins.
 */
final class LegFollower {
  private static final double LOOK_AHEAD_M = 300.0;
  private static final double TURN_MPS2 = Gravity.STANDARD_MPS2 * Math.tan(Math.toRadians(22.0));
  private static final double TURN_LAG_S = 1.5;
  private static final double THRESHOLD_M = 100.0;

  private final Course course;
  private double fromNorth;
  private double fromEast;
  private int leg;
  private double turnS;

  LegFollower(Course course) {
    this.course = course;
  }

  int leg() {
    return leg;
  }

  /** How long the turn into the present leg takes [s]. */
  double turnS() {
    return turnS;
  }

  boolean finished() {
    return leg >= course.marks().size();
  }

  /** Distance from the present leg, right positive [m]. */
  double offsetM(FlightState state) {
    double bearing = bearing(leg);
    double north = state.northM() - fromNorth;
    double east = state.eastM() - fromEast;
    return east * Math.cos(bearing) - north * Math.sin(bearing);
  }

  GuidanceTarget follow(FlightState state) {
    Course.Mark mark = course.marks().get(leg);
    double bearing = bearing(leg);
    double remaining =
        (mark.northM() - state.northM()) * Math.cos(bearing)
            + (mark.eastM() - state.eastM()) * Math.sin(bearing);
    if (remaining < anticipation(state, bearing)) {
      boolean more = leg + 1 < course.marks().size();
      double turn = more ? Math.abs(Limit.angle(bearing(leg + 1) - bearing)) : 0.0;
      turnS = turn * state.groundSpeedMps() / TURN_MPS2;
      fromNorth = mark.northM();
      fromEast = mark.eastM();
      leg++;
      if (finished()) {
        leg--;
        GuidanceTarget last = point(state);
        leg++;
        return last;
      }
    }
    return point(state);
  }

  private double anticipation(FlightState state, double bearing) {
    if (leg + 1 >= course.marks().size()) {
      return 0.0;
    }
    double speed = state.groundSpeedMps();
    double turn = Math.abs(Limit.angle(bearing(leg + 1) - bearing));
    double radius = speed * speed / TURN_MPS2;
    double miss = 0.6 * THRESHOLD_M;
    double touching = radius * Math.tan(Math.min(turn, 3.0) / 2.0);
    return Math.min(touching, Math.sqrt(2.0 * radius * miss + miss * miss)) + speed * TURN_LAG_S;
  }

  private GuidanceTarget point(FlightState state) {
    Course.Mark mark = course.marks().get(leg);
    double bearing = bearing(leg);
    double along =
        (state.northM() - fromNorth) * Math.cos(bearing)
            + (state.eastM() - fromEast) * Math.sin(bearing)
            + LOOK_AHEAD_M;
    return new GuidanceTarget(
        fromNorth + along * Math.cos(bearing) - state.northM(),
        fromEast + along * Math.sin(bearing) - state.eastM(),
        mark.altitudeM(),
        OptionalDouble.empty());
  }

  private double bearing(int index) {
    Course.Mark to = course.marks().get(index);
    double north = index == 0 ? 0.0 : course.marks().get(index - 1).northM();
    double east = index == 0 ? 0.0 : course.marks().get(index - 1).eastM();
    if (index == leg) {
      north = fromNorth;
      east = fromEast;
    }
    return Math.atan2(to.eastM() - east, to.northM() - north);
  }
}
