package org.u2sa.interfaces.units;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.frame.Gravity;

/**
 * Units allowed in files, converted at the edge; SI and radians inside. Quotients of known units
 * ({@code %/deg}) are supported. Factors: NIST SP 811 (2008), appendix B.8; the knot and nautical
 * mile are exact (1852 m).
 */
public final class Units {
  private static final double FOOT_M = 0.3048;
  private static final double MILE_M = 1609.344;
  private static final double NAUTICAL_MILE_M = 1852.0;
  private static final double HOUR_S = 3600.0;
  private static final double MINUTE_S = 60.0;
  private static final double POUND_KG = 0.45359237;
  private static final double DEGREE_RAD = Math.PI / 180.0;
  private static final double CELSIUS_ZERO_K = 273.15;
  private static final Map<String, Unit> TABLE = table();

  private Units() {}

  /** A unit: SI value = value * factor + offset. */
  private record Unit(String dimension, double factor, double offset) {}

  private static Map<String, Unit> table() {
    Map<String, Unit> table = new LinkedHashMap<>();
    add(table, "length", 1.0, "m");
    add(table, "length", 1000.0, "km");
    add(table, "length", 0.01, "cm");
    add(table, "length", 0.001, "mm");
    add(table, "length", FOOT_M, "ft");
    add(table, "length", FOOT_M / 12.0, "in");
    add(table, "length", NAUTICAL_MILE_M, "nmi", "NM");
    add(table, "length", MILE_M, "mi");
    add(table, "angle", 1.0, "rad");
    add(table, "angle", DEGREE_RAD, "deg", "°");
    add(table, "speed", 1.0, "m/s");
    add(table, "speed", 1000.0 / HOUR_S, "km/h");
    add(table, "speed", NAUTICAL_MILE_M / HOUR_S, "kt", "kn");
    add(table, "speed", MILE_M / HOUR_S, "mph");
    add(table, "speed", FOOT_M, "ft/s");
    add(table, "speed", FOOT_M / MINUTE_S, "ft/min", "fpm");
    add(table, "angular rate", 1.0, "rad/s");
    add(table, "angular rate", DEGREE_RAD, "deg/s");
    add(table, "angular rate", 2.0 * Math.PI / MINUTE_S, "rpm");
    add(table, "acceleration", 1.0, "m/s^2", "m/s²");
    add(table, "acceleration", FOOT_M, "ft/s^2", "ft/s²");
    add(table, "acceleration", Gravity.STANDARD_MPS2, "g");
    add(table, "time", 1.0, "s");
    add(table, "time", 0.001, "ms");
    add(table, "time", 1.0e-6, "us", "µs");
    add(table, "time", MINUTE_S, "min");
    add(table, "time", HOUR_S, "h");
    add(table, "frequency", 1.0, "Hz", "1/s");
    add(table, "frequency", 1000.0, "kHz");
    add(table, "ratio", 1.0, "1");
    add(table, "ratio", 0.01, "%");
    add(table, "mass", 1.0, "kg");
    add(table, "mass", POUND_KG, "lb");
    add(table, "force", 1.0, "N");
    add(table, "force", POUND_KG * Gravity.STANDARD_MPS2, "lbf");
    add(table, "pressure", 1.0, "Pa");
    add(table, "pressure", 100.0, "hPa", "mbar");
    add(table, "pressure", 1000.0, "kPa");
    add(table, "pressure", 3386.389, "inHg");
    add(table, "pressure", POUND_KG * Gravity.STANDARD_MPS2 * 144.0 / (FOOT_M * FOOT_M), "psi");
    add(table, "voltage", 1.0, "V");
    add(table, "voltage", 0.001, "mV");
    add(table, "current", 1.0, "A");
    add(table, "current", 0.001, "mA");
    add(table, "power", 1.0, "W");
    add(table, "power", 1000.0, "kW");
    add(table, "temperature", 1.0, "K");
    table.put("degC", new Unit("temperature", 1.0, CELSIUS_ZERO_K));
    table.put("degF", new Unit("temperature", 5.0 / 9.0, CELSIUS_ZERO_K - 32.0 * 5.0 / 9.0));
    return table;
  }

  private static void add(Map<String, Unit> table, String dimension, double si, String... names) {
    for (String name : names) {
      table.put(name, new Unit(dimension, si, 0.0));
    }
  }

  /**
   * Converts between units; a unit converts to itself even if unknown.
   *
   * @throws IllegalArgumentException if a unit is unknown or they measure different quantities;
   *     lists valid units
   */
  public static double convert(double value, String from, String to) {
    if (from.equals(to)) {
      return value;
    }
    Unit target = find(to).orElseThrow(() -> new IllegalArgumentException(noConversion(from, to)));
    Unit source =
        find(from).orElseThrow(() -> new IllegalArgumentException(unknown(from, target.dimension)));
    if (!source.dimension.equals(target.dimension)) {
      throw new IllegalArgumentException(
          String.format(
              "unit \"%s\" measures %s, expected %s: %s",
              from,
              source.dimension,
              target.dimension,
              String.join(", ", unitsOf(target.dimension, to))));
    }
    return source.factor == target.factor && source.offset == target.offset
        ? value
        : (value * source.factor + source.offset - target.offset) / target.factor;
  }

  private static Optional<Unit> find(String name) {
    Unit listed = TABLE.get(name);
    if (listed != null) {
      return Optional.of(listed);
    }
    int slash = name.lastIndexOf('/');
    if (slash <= 0) {
      return Optional.empty();
    }
    Unit below = TABLE.get(name.substring(slash + 1));
    Unit above = TABLE.get(name.substring(0, slash));
    if (above == null || below == null || above.offset != 0.0 || below.offset != 0.0) {
      return Optional.empty();
    }
    return Optional.of(
        new Unit(above.dimension + " per " + below.dimension, above.factor / below.factor, 0.0));
  }

  private static String unknown(String unit, String dimension) {
    List<String> known = unitsOf(dimension, "");
    return String.format(
        "unknown unit \"%s\"; expected %s%s%s",
        unit,
        dimension,
        known.isEmpty() ? "" : ": " + String.join(", ", known),
        NearestNames.didYouMean(unit, known));
  }

  private static String noConversion(String from, String to) {
    return "unit \"" + from + "\" cannot be converted to \"" + to + "\"; expected \"" + to + "\"";
  }

  private static List<String> unitsOf(String dimension, String orOnly) {
    List<String> names = new ArrayList<>();
    TABLE.forEach(
        (name, unit) -> {
          if (unit.dimension.equals(dimension)) {
            names.add(name);
          }
        });
    if (names.isEmpty() && !orOnly.isEmpty()) {
      names.add(orOnly);
    }
    return names;
  }
}
