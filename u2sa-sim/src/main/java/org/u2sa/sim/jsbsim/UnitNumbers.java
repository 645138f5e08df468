package org.u2sa.sim.jsbsim;

import java.util.Map;
import org.u2sa.interfaces.xml.XmlElement;

/** Numbers in JSBSim's files, by default (without {@code unit}) in the expected unit. */
final class UnitNumbers {
  static final String FT = "FT";
  static final String LBS = "LBS";
  static final String PURE = "";

  static final double M_PER_FT = 0.3048;
  static final double KG_PER_LB = 0.45359237;
  static final double N_PER_LBF = 4.4482216152605;
  static final double LB_PER_SLUG = 32.174049; // as JSBSim converts weight to mass
  static final double NM_PER_FTLBF = N_PER_LBF * M_PER_FT;
  static final double KG_M2_PER_SLUG_FT2 = NM_PER_FTLBF;
  static final double FTLBF_PER_S_PER_HP = 550.0;
  static final double W_PER_HP = 745.69987;

  private record Unit(char kind, double factor) {}

  private static final Map<String, Unit> UNITS =
      Map.ofEntries(
          Map.entry(FT, new Unit('l', 1.0)),
          Map.entry("IN", new Unit('l', 1.0 / 12.0)),
          Map.entry("M", new Unit('l', 1.0 / M_PER_FT)),
          Map.entry("FT2", new Unit('a', 1.0)),
          Map.entry("M2", new Unit('a', 1.0 / (M_PER_FT * M_PER_FT))),
          Map.entry(LBS, new Unit('w', 1.0)),
          Map.entry("KG", new Unit('w', 1.0 / KG_PER_LB)),
          Map.entry("SLUG*FT2", new Unit('j', 1.0)),
          Map.entry("KG*M2", new Unit('j', 1.0 / KG_M2_PER_SLUG_FT2)),
          Map.entry("RAD", new Unit('r', 1.0)),
          Map.entry("DEG", new Unit('r', StrictMath.PI / 180.0)),
          Map.entry("LBS/FT", new Unit('k', 1.0)),
          Map.entry("N/M", new Unit('k', M_PER_FT / N_PER_LBF)),
          Map.entry("LBS/FT/SEC", new Unit('c', 1.0)),
          Map.entry("N/M/SEC", new Unit('c', M_PER_FT / N_PER_LBF)),
          Map.entry("PA", new Unit('p', 1.0)),
          Map.entry("INHG", new Unit('p', 3_386.38)),
          Map.entry("IN3", new Unit('v', 1.0)),
          Map.entry("CC", new Unit('v', 1.0 / 16.387064)),
          Map.entry("LTR", new Unit('v', 1_000.0 / 16.387064)),
          Map.entry("HP", new Unit('h', 1.0)),
          Map.entry("WATTS", new Unit('h', 1.0 / W_PER_HP)),
          Map.entry("LBS/HP*HR", new Unit('b', 1.0)));

  private UnitNumbers() {}

  /** A required child's number. */
  static double number(XmlElement parent, String child, String unit) {
    return of(parent.requiredChild(child), unit);
  }

  /** An optional child's number. */
  static double number(XmlElement parent, String child, String unit, double ifAbsent) {
    return parent.child(child).map(each -> of(each, unit)).orElse(ifAbsent);
  }

  static double of(XmlElement element, String unit) {
    return plain(element, element.text()) * factor(element, unit);
  }

  /** A number without unit. */
  static double plain(XmlElement element, String text) {
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw element.error("\"" + text + "\": expected a number", e);
    }
    throw element.error("\"" + text + "\": expected a finite number");
  }

  /** Children x, y and z in structural axes: aft, right, up [ft]. */
  static double[] place(XmlElement location) {
    location.refuseUnknownChildren("x", "y", "z");
    double factor = factor(location, "IN") * UNITS.get("IN").factor;
    return new double[] {
      factor * number(location, "x", PURE),
      factor * number(location, "y", PURE),
      factor * number(location, "z", PURE)
    };
  }

  /** Factor from an element's unit to the expected one. */
  static double factor(XmlElement element, String expected) {
    String stated = element.optionalAttribute("unit").orElse(expected);
    if (stated.equals(expected)) {
      return 1.0;
    }
    Unit from = UNITS.get(stated);
    Unit to = UNITS.get(expected);
    if (from == null || to == null || from.kind != to.kind) {
      throw element.error("unit \"" + stated + "\": expected " + expected + " or a related unit");
    }
    return from.factor / to.factor;
  }
}
