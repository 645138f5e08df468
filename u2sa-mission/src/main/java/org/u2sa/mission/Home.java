package org.u2sa.mission;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/**
 * Start and return position of the vehicle: runway threshold, dock.
 *
 * @param referenceFrame the axes of x, y and z
 * @param x along x [m]; longitude [deg, east +] in GLOBAL
 * @param y along y [m]; latitude [deg, north +] in GLOBAL
 * @param z along z [m]; altitude above mean sea level, up, in GLOBAL; empty if not given
 * @param headingRad [rad, clockwise from true north, 0…2π); empty if not given
 */
public record Home(
    ReferenceFrame referenceFrame,
    double x,
    double y,
    OptionalDouble z,
    OptionalDouble headingRad) {
  /** Name of the goal to which a vehicle returns on command; also of the home's element. */
  static final String NAME = "home";

  /** Geographic position, at altitude 0 if none is given; empty in a local frame. */
  public Optional<Geodetic> geodetic() {
    return referenceFrame.equals(ReferenceFrame.GLOBAL)
        ? Optional.of(new Geodetic(x, y, z.orElse(0.0)))
        : Optional.empty();
  }

  /**
   * Waypoint above this position at the vehicle's current altitude: an aircraft must not descend to
   * its runway.
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
