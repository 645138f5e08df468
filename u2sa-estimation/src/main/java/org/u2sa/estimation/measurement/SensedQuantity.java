package org.u2sa.estimation.measurement;

/**
 * Quantity measured by one measurement vector. The components of a vector are accepted or gated
 * together and share one factor on their standard deviations.
 */
public enum SensedQuantity {
  /**
   * Angular rates about BODY_FRD axes [rad/s]; with the specific force they drive the prediction.
   */
  BODY_RATES(3),
  /** Specific force along BODY_FRD [m/s²]. */
  SPECIFIC_FORCE(3),
  /** Latitude and longitude [rad]; standard deviations north and east [m]. */
  PLACE(2),
  /** Altitude, up [m]. */
  ALTITUDE(1),
  /** Position north and east of a local origin [m]. */
  LOCAL_PLACE(2),
  /** Position down from a local origin [m]. */
  LOCAL_DOWN(1),
  /** Velocity over ground: north, east, down [m/s]. */
  VELOCITY(3),
  /** Velocity over ground along BODY_FRD [m/s]. */
  BODY_VELOCITY(3),
  /** Roll and pitch [rad]. */
  TILT(2),
  /** Heading [rad, clockwise from true north]. */
  HEADING(1),
  /** Rates of roll, pitch and heading [rad/s]. */
  EULER_RATES(3),
  /** Velocity through the fluid along BODY_FRD [m/s]. */
  FLUID_VELOCITY(3),
  /** Range [m] and bearing [rad, clockwise from the nose] of a landmark with a known position. */
  LANDMARK(2);

  private static final SensedQuantity[] ALL = values();

  private final int size;

  SensedQuantity(int size) {
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

  /** Number of components. */
  public int size() {
    return size;
  }

  /** Whether this is a horizontal position. */
  public boolean isPlace() {
    return this == PLACE || this == LOCAL_PLACE;
  }

  /** Whether sources of the two quantities can corroborate each other. */
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
