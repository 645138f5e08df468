package org.u2sa.estimation.measurement;

/**
 * A source's measurement at one time, in the filter's axes and units: up to three components of
 * each {@link SensedQuantity} with their standard deviations. Reusable, so that the filter need not
 * allocate.
 */
public final class Measurement {
  private static final int WIDTH = 3;

  /** Total number of values. */
  public static final int SIZE = SensedQuantity.count() * WIDTH;

  private final double[] values = new double[SIZE];
  private final double[] sigmas = new double[SIZE];
  private final byte[] present = new byte[SensedQuantity.count()];
  private final double[] landmark = new double[2];
  private final double[] mounted = new double[WIDTH];
  private boolean isLandmarkOnEarth;
  private String source = "";
  private long micros;

  /** Clears it for a measurement with the given source and time [µs]. */
  public Measurement begin(String newSource, long newMicros) {
    source = newSource;
    micros = newMicros;
    java.util.Arrays.fill(present, (byte) 0);
    java.util.Arrays.fill(values, 0.0);
    java.util.Arrays.fill(sigmas, 0.0);
    java.util.Arrays.fill(mounted, 0.0);
    return this;
  }

  /** Copies all values of another measurement. */
  public void copyFrom(Measurement other) {
    source = other.source;
    micros = other.micros;
    System.arraycopy(other.values, 0, values, 0, values.length);
    System.arraycopy(other.sigmas, 0, sigmas, 0, sigmas.length);
    System.arraycopy(other.present, 0, present, 0, present.length);
    System.arraycopy(other.landmark, 0, landmark, 0, landmark.length);
    System.arraycopy(other.mounted, 0, mounted, 0, WIDTH);
    isLandmarkOnEarth = other.isLandmarkOnEarth;
  }

  /** Sets one component of a quantity, in the unit of the quantity, with its standard deviation. */
  public void set(SensedQuantity quantity, int component, double value, double sigma) {
    int at = quantity.ordinal() * WIDTH + component;
    values[at] = value;
    sigmas[at] = sigma;
    present[quantity.ordinal()] |= (byte) (1 << component);
  }

  /** Sets the sensor's offset from the reference point, BODY_FRD [m]; {@link #begin} resets it. */
  public Measurement mounted(double forward, double right, double down) {
    mounted[0] = forward;
    mounted[1] = right;
    mounted[2] = down;
    return this;
  }

  /** Offset of the sensor along an axis of BODY_FRD [m]. */
  public double mounted(int axis) {
    return mounted[axis];
  }

  private Measurement vector(SensedQuantity quantity, double sigma, double... components) {
    for (int i = 0; i < components.length; i++) {
      set(quantity, i, components[i], sigma);
    }
    return this;
  }

  /** Position on WGS-84 [deg], standard deviations north and east [m]. */
  public Measurement place(double latitudeDeg, double longitudeDeg, double north, double east) {
    set(SensedQuantity.PLACE, 0, Math.toRadians(latitudeDeg), north);
    set(SensedQuantity.PLACE, 1, Math.toRadians(longitudeDeg), east);
    return this;
  }

  /** Altitude above mean sea level [m]. */
  public Measurement altitude(double metres, double sigma) {
    return vector(SensedQuantity.ALTITUDE, sigma, metres);
  }

  /** Position in a local frame: north and east [m]. */
  public Measurement localPlace(double north, double east, double sigma) {
    return vector(SensedQuantity.LOCAL_PLACE, sigma, north, east);
  }

  /** Velocity over ground: north, east, down [m/s]. */
  public Measurement velocity(double north, double east, double down, double sigma) {
    return vector(SensedQuantity.VELOCITY, sigma, north, east, down);
  }

  /** Velocity over ground, horizontal: north, east [m/s]. */
  public Measurement velocity(double north, double east, double sigma) {
    return vector(SensedQuantity.VELOCITY, sigma, north, east);
  }

  /** Speed over ground, forward [m/s]. */
  public Measurement forward(double mps, double sigma) {
    return vector(SensedQuantity.BODY_VELOCITY, sigma, mps);
  }

  /** Speed through the fluid, forward [m/s]. */
  public Measurement forwardThroughFluid(double mps, double sigma) {
    return vector(SensedQuantity.FLUID_VELOCITY, sigma, mps);
  }

  /**
   * Sets range and bearing of a landmark with a known position.
   *
   * @param range horizontal range [m]
   * @param bearing bearing [rad], clockwise from the vehicle's nose
   */
  public Measurement sighting(double range, double bearing, double rangeSigma, double sigma) {
    set(SensedQuantity.LANDMARK, 0, range, rangeSigma);
    set(SensedQuantity.LANDMARK, 1, bearing, sigma);
    return this;
  }

  /** Position of the landmark in the local frame: north and east [m]. */
  public Measurement ofLocal(double north, double east) {
    landmark[0] = north;
    landmark[1] = east;
    isLandmarkOnEarth = false;
    return this;
  }

  /** Position of the landmark on WGS-84 [deg]. */
  public Measurement ofPlace(double latitudeDeg, double longitudeDeg) {
    landmark[0] = Math.toRadians(latitudeDeg);
    landmark[1] = Math.toRadians(longitudeDeg);
    isLandmarkOnEarth = true;
    return this;
  }

  /** Landmark position: latitude and longitude [rad], or north and east [m]. */
  public double landmark(int component) {
    return landmark[component];
  }

  /** Whether the landmark position is latitude and longitude. */
  public boolean isLandmarkOnEarth() {
    return isLandmarkOnEarth;
  }

  /** Heading [rad], clockwise from true north. */
  public Measurement heading(double rad, double sigma) {
    return vector(SensedQuantity.HEADING, sigma, rad);
  }

  /** Rate of the heading [rad/s], clockwise positive. */
  public Measurement turnRate(double radPerS, double sigma) {
    set(SensedQuantity.EULER_RATES, 2, radPerS, sigma);
    return this;
  }

  /** Angular rates about BODY_FRD axes [rad/s]. */
  public Measurement bodyRates(double x, double y, double z, double sigma) {
    return vector(SensedQuantity.BODY_RATES, sigma, x, y, z);
  }

  /** Specific force along BODY_FRD axes [m/s²]; (0, 0, -9.8) at rest. */
  public Measurement specificForce(double x, double y, double z, double sigma) {
    return vector(SensedQuantity.SPECIFIC_FORCE, sigma, x, y, z);
  }

  /** Name of the source. */
  public String source() {
    return source;
  }

  /** Time of the measurement [µs]. */
  public long micros() {
    return micros;
  }

  /** Whether at least one component of the quantity is measured. */
  public boolean has(SensedQuantity quantity) {
    return present[quantity.ordinal()] != 0;
  }

  /** Whether that component of the quantity is measured. */
  public boolean has(SensedQuantity quantity, int component) {
    return (present[quantity.ordinal()] & 1 << component) != 0;
  }

  /** Whether all components of the quantity are measured. */
  public boolean isWhole(SensedQuantity quantity) {
    return present[quantity.ordinal()] == (1 << quantity.size()) - 1;
  }

  /** Value of a component, in the unit of the quantity. */
  public double value(SensedQuantity quantity, int component) {
    return values[quantity.ordinal() * WIDTH + component];
  }

  /** Standard deviation of a component, in the unit of the quantity. */
  public double sigma(SensedQuantity quantity, int component) {
    return sigmas[quantity.ordinal() * WIDTH + component];
  }

  /**
   * Whether the values saved in an array are repeated: the horizontal position if there is one,
   * otherwise all. A receiver that holds its position may still report new altitudes.
   */
  public boolean repeats(double[] kept, int from) {
    boolean isPlaced = has(SensedQuantity.PLACE) || has(SensedQuantity.LOCAL_PLACE);
    for (int i = 0; i < values.length; i++) {
      boolean counts = !isPlaced || SensedQuantity.at(i / WIDTH).isPlace();
      if (counts && values[i] != kept[from + i]) {
        return false;
      }
    }
    return true;
  }

  /** Writes the measurement into an array, starting at an index; returns the index after it. */
  public int keep(double[] to, int from) {
    System.arraycopy(values, 0, to, from, values.length);
    return values.length;
  }
}
