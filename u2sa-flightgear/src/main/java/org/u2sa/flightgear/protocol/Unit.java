package org.u2sa.flightgear.protocol;

/** Units in FlightGear's lines, each with its factor to the unit that U2SA uses. */
enum Unit {
  SECOND("s", 1.0),
  DEGREE_OF_EARTH("deg", 1.0), // longitude and latitude stay in degrees
  DEGREE("deg", Math.PI / 180.0),
  DEGREE_PER_SECOND("deg/s", Math.PI / 180.0),
  FOOT("ft", 0.3048), // international foot, exact
  FOOT_PER_SECOND("ft/s", 0.3048),
  KNOT("kt", 1_852.0 / 3_600.0), // international nautical mile, exact
  PER_MINUTE("1/min", 1.0),
  NONE("", 1.0);

  private final String symbol;
  private final double factor;

  Unit(String symbol, double factor) {
    this.symbol = symbol;
    this.factor = factor;
  }

  String symbol() {
    return symbol;
  }

  double toUsed(double onTheLine) {
    return onTheLine * factor;
  }

  double toLine(double used) {
    return used / factor;
  }
}
