package org.u2sa.estimation.measurement;

/**
 * Quantity measured by one measurement vector. The components of a vector are accepted or gated
 * together and share one factor on their standard deviations.
 */
public enum SensedQuantity {
  /**
   * Angular rates about BODY_FRD axes [rad/s]; with the specific force they drive the prediction.
   */
  BODY_RATES("angular rates", 3),
  /** Specific force along BODY_FRD [m/s²]. */
  SPECIFIC_FORCE("specific force", 3),
  /** Latitude and longitude [rad]; standard deviations north and east [m]. */
  PLACE("position", 2),
  /** Altitude, up [m]. */
  ALTITUDE("altitude", 1),
  /** Position north and east of a local origin [m]. */
  LOCAL_PLACE("local position", 2),
  /** Position down from a local origin [m]. */
  LOCAL_DOWN("local depth", 1),
  /** Velocity over ground: north, east, down [m/s]. */
  VELOCITY("velocity", 3),
  /** Velocity over ground along BODY_FRD [m/s]. */
  BODY_VELOCITY("speed along the vehicle", 3),
  /** Roll and pitch [rad]. */
  TILT("roll and pitch", 2),
  /** Heading [rad, clockwise from true north]. */
  HEADING("heading", 1),
  /** Rates of roll, pitch and heading [rad/s]. */
  EULER_RATES("turn rates", 3),
  /** Velocity through the fluid along BODY_FRD [m/s]. */
  FLUID_VELOCITY("speed through the fluid", 3),
  /** Range [m] and bearing [rad, clockwise from the nose] of a landmark with a known position. */
  LANDMARK("landmark", 2);

  private static final SensedQuantity[] ALL = values();

  private final String text;
  private final int size;

  SensedQuantity(String text, int size) {
    this.text = text;
    this.size = size;
  }

  /** Quantity by ordinal, without copying the array. */
  public static SensedQuantity at(int ordinal) {
    return ALL[ordinal];
  }

  /** Number of quantities. */
  public static int count() {
    return ALL.length;
  }

  /** Name for reports, such as "heading". */
  String text() {
    return text;
  }

  /** Number of components. */
  public int size() {
    return size;
  }

  /** Whether sources of these two quantities can corroborate each other. */
  public boolean corroborates(SensedQuantity other) {
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
