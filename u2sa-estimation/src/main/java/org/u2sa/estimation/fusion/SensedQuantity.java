package org.u2sa.estimation.fusion;

/**
 * What one measurement vector is of. The components of a vector are accepted or gated together, and
 * share one factor of their standard deviations.
 */
enum SensedQuantity {
  /** Rates about and forces along BODY_FRD axes that drive the prediction; six numbers in two. */
  BODY_RATES("angular rates", 3),
  /** Specific force along BODY_FRD [m/s²]. */
  SPECIFIC_FORCE("specific force", 3),
  /** Latitude and longitude [rad]; deviations north and east [m]. */
  PLACE("position", 2),
  /** Altitude, up [m]. */
  ALTITUDE("altitude", 1),
  /** North and east of a local origin [m]. */
  LOCAL_PLACE("local position", 2),
  /** Down from a local origin [m]. */
  LOCAL_DOWN("local depth", 1),
  /** Over ground: north, east, down [m/s]. */
  VELOCITY("velocity", 3),
  /** Over ground along BODY_FRD [m/s]. */
  BODY_VELOCITY("speed along the vehicle", 3),
  /** Roll and pitch [rad]. */
  TILT("roll and pitch", 2),
  /** Heading [rad, clockwise from true north]. */
  HEADING("heading", 1),
  /** Rates of roll, pitch and heading [rad/s]. */
  EULER_RATES("turn rates", 3),
  /** Through the fluid along BODY_FRD [m/s]. */
  FLUID_VELOCITY("speed through the fluid", 3),
  /** Range [m] and bearing [rad, clockwise from the nose] of something whose place is known. */
  LANDMARK("landmark", 2);

  private static final SensedQuantity[] ALL = values();

  private final String text;
  private final int size;

  SensedQuantity(String text, int size) {
    this.text = text;
    this.size = size;
  }

  /** All, without a copy. */
  static SensedQuantity at(int ordinal) {
    return ALL[ordinal];
  }

  static int count() {
    return ALL.length;
  }

  /** For reports: "heading". */
  String text() {
    return text;
  }

  int size() {
    return size;
  }

  /** Whether two sources that measure these can vouch for each other. */
  boolean corroborates(SensedQuantity other) {
    return this == other || kin(this) == kin(other);
  }

  private static int kin(SensedQuantity quantity) {
    switch (quantity) {
      case PLACE:
      case LOCAL_PLACE:
      case LANDMARK:
        return -1;
      case ALTITUDE:
      case LOCAL_DOWN:
        return -2;
      case VELOCITY:
      case BODY_VELOCITY:
        return -3;
      default:
        return quantity.ordinal();
    }
  }
}
