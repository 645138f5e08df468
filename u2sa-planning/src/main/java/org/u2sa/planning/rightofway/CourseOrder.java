package org.u2sa.planning.rightofway;

import java.util.Locale;

/**
 * Course and speed required by right of way instead of those to the goal. Immutable.
 *
 * @param courseRad course over ground, clockwise from north [rad]
 * @param speedShare fraction of the wanted speed; 0: stop
 * @param fromRad course to the goal when it was chosen [rad]
 * @param reason rule and vessel, for operators
 */
public record CourseOrder(double courseRad, double speedShare, double fromRad, String reason) {
  /** Change of course, positive to starboard [rad, −π…π]. */
  public double changeRad() {
    return Angles.wrapped(courseRad - fromRad);
  }

  /** Text of the order: rule and vessel, course, change of course, speed. */
  @Override
  public String toString() {
    long change = Math.round(Math.toDegrees(changeRad()));
    String course =
        change == 0
            ? "keeps its course"
            : String.format(
                Locale.ROOT,
                "course %03d, %d degrees to %s",
                Angles.degrees(courseRad),
                Math.abs(change),
                change > 0 ? "starboard" : "port");
    String speed =
        speedShare > 0.0
            ? String.format(Locale.ROOT, ", %.0f %% of its speed", 100.0 * speedShare)
            : ", stops";
    return reason + ": " + course + (speedShare == 1.0 ? "" : speed);
  }
}
