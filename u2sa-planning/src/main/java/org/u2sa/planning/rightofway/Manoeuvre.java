package org.u2sa.planning.rightofway;

/**
 * Course and speed that right of way demands instead of those to the goal. Immutable.
 *
 * @param courseRad course over ground, clockwise from north [rad]
 * @param speedShare fraction of the wanted speed; 0: stop
 * @param fromRad course to the goal when it was chosen [rad]
 * @param reason rule and vessel, for operators
 */
public record Manoeuvre(double courseRad, double speedShare, double fromRad, String reason) {
  /** Change of course, positive to starboard [rad, −π…π]. */
  public double changeRad() {
    return Angles.wrapped(courseRad - fromRad);
  }
}
