package org.u2sa.mission;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
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
  private static final double FULL_TURN_RAD = 2.0 * Math.PI;

  /** Name of the goal to which a vehicle returns on command; also of the home's element. */
  public static final String NAME = "home";

  /** Reads {@code <home>}. */
  static Home read(XmlElement home) {
    home.refuseUnknownAttributes();
    home.refuseUnknownChildren("reference", "referenceFrame", "x", "y", "z", "psi");
    ReferenceFrame frame = frame(home);
    boolean global = frame.equals(ReferenceFrame.GLOBAL);
    String horizontal = global ? "deg" : "m";
    double x = number(home, "x", horizontal, horizontal).orElseThrow(() -> missing(home, "x"));
    double y = number(home, "y", horizontal, horizontal).orElseThrow(() -> missing(home, "y"));
    if (global) {
      XmlNumbers.checkLongitude(home.child("x").orElseThrow(), x);
      XmlNumbers.checkLatitude(home.child("y").orElseThrow(), y);
    }
    Optional<Double> z = number(home, "z", "m", "m");
    Optional<Double> psi = number(home, "psi", "deg", "rad");
    return new Home(frame, x, y, optional(z), optional(psi.map(Home::wrapped)));
  }

  private static ReferenceFrame frame(XmlElement home) {
    Optional<XmlElement> element = home.child("reference").or(() -> home.child("referenceFrame"));
    if (element.isEmpty()) {
      return ReferenceFrame.GLOBAL;
    }
    try {
      ReferenceFrame frame = ReferenceFrame.parse(element.get().text());
      requireFixed(frame, element.get());
      return frame;
    } catch (IllegalArgumentException e) {
      throw element.get().error(e.getMessage(), e);
    }
  }

  /** Rejects frames that move with the vehicle. */
  static void requireFixed(ReferenceFrame frame, XmlElement element) {
    if (frame.isBody()) {
      throw element.error(
          "\"" + frame + "\" moves with the vehicle; expected GLOBAL, LOCAL_ENU, LOCAL_NED or UTM");
    }
  }

  private static Optional<Double> number(XmlElement home, String name, String ifUnset, String to) {
    Optional<XmlElement> element = home.child(name);
    element.ifPresent(each -> each.refuseUnknownAttributes("unit"));
    return element.map(each -> XmlNumbers.converted(each, ifUnset, to));
  }

  private static RuntimeException missing(XmlElement home, String name) {
    return home.error("lacks <" + name + ">; expected x, y, and optionally z and psi");
  }

  private static OptionalDouble optional(Optional<Double> value) {
    return value.map(OptionalDouble::of).orElseGet(OptionalDouble::empty);
  }

  private static double wrapped(double headingRad) {
    double remainder = headingRad % FULL_TURN_RAD;
    return remainder < 0.0 ? remainder + FULL_TURN_RAD : remainder;
  }

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
