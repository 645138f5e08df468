package org.u2sa.mission;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.ReferenceFrame;

/** Reads {@code <home>}. */
final class HomeReader {
  private static final double FULL_TURN_RAD = 2.0 * Math.PI;

  private HomeReader() {}

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
    return new Home(frame, x, y, optional(z), optional(psi.map(HomeReader::wrapped)));
  }

  private static ReferenceFrame frame(XmlElement home) {
    Optional<XmlElement> element = home.child("reference");
    if (element.isEmpty()) {
      element = home.child("referenceFrame");
    }
    if (element.isEmpty()) {
      return ReferenceFrame.GLOBAL;
    }
    try {
      ReferenceFrame frame = ReferenceFrame.parse(element.get().text());
      if (frame.isBody()) {
        throw element
            .get()
            .error(
                "\""
                    + frame
                    + "\" moves with the vehicle; expected GLOBAL, LOCAL_ENU, LOCAL_NED or UTM");
      }
      return frame;
    } catch (IllegalArgumentException e) {
      throw element.get().error(e.getMessage(), e);
    }
  }

  private static Optional<Double> number(XmlElement home, String name, String ifUnset, String to) {
    Optional<XmlElement> element = home.child(name);
    element.ifPresent(each -> each.refuseUnknownAttributes("unit"));
    return element.map(each -> XmlNumbers.converted(each, ifUnset, to));
  }

  private static RuntimeException missing(XmlElement home, String name) {
    return home.error("lacks <" + name + ">; expected x, y, and if wanted z and psi");
  }

  private static OptionalDouble optional(Optional<Double> value) {
    return value.isPresent() ? OptionalDouble.of(value.get()) : OptionalDouble.empty();
  }

  private static double wrapped(double headingRad) {
    double remainder = headingRad % FULL_TURN_RAD;
    return remainder < 0.0 ? remainder + FULL_TURN_RAD : remainder;
  }
}
