package org.u2sa.core.mission;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Where a mission's vehicle starts and returns to: runway threshold, dock.
 *
 * @param referenceFrame the axes of x, y and z
 * @param x along x [m]; longitude [deg, east +] in GLOBAL
 * @param y along y [m]; latitude [deg, north +] in GLOBAL
 * @param z along z [m]; altitude above mean sea level, up, in GLOBAL; empty if the mission does not
 *     say
 * @param headingRad [rad, clockwise from true north, 0…2π); empty if the mission does not say
 */
public record Home(
    ReferenceFrame referenceFrame,
    double x,
    double y,
    OptionalDouble z,
    OptionalDouble headingRad) {
  /**
   * The place on the earth, at altitude 0 if the mission gives none; empty if the frame is a local
   * one.
   */
  public Optional<Geodetic> geodetic() {
    return referenceFrame.equals(ReferenceFrame.GLOBAL)
        ? Optional.of(new Geodetic(x, y, z.orElse(0.0)))
        : Optional.empty();
  }

  /**
   * A waypoint over this place, at whatever altitude the vehicle has: an aircraft is not to descend
   * to its runway.
   */
  Waypoint waypoint(String name, double thresholdM) {
    return new Waypoint()
        .uid(name)
        .referenceFrame(referenceFrame)
        .x(x)
        .y(y)
        .horizontalThreshold(thresholdM);
  }
}
