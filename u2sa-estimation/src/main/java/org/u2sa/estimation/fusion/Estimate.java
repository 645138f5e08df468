package org.u2sa.estimation.fusion;

import org.u2sa.estimation.rotation.Quaternions;

/**
 * The filter's estimate at one time: a view that is valid until the next query. The has… methods
 * show which quantities are known.
 */
public final class Estimate {
  private static final double VERTICAL = 0.02; // cos θ below which the heading's rate is undefined

  private final FilterState s;
  private final MeasurementModel model;
  private final FilterTuning tuning;
  private final double[] r = new double[9];
  private final double[] attitudeSigmas = new double[3];

  Estimate(FilterState s, MeasurementModel model, FilterTuning tuning) {
    this.s = s;
    this.model = model;
    this.tuning = tuning;
    Quaternions.matrix(s.x, FilterState.Q, r);
    model.attitudeSigmas(s, attitudeSigmas);
  }

  /** Time of the estimate [µs]. */
  public long micros() {
    return s.micros;
  }

  /** Whether the geodetic position is known. */
  public boolean isOnEarth() {
    return s.hasPlace;
  }

  /**
   * Whether the horizontal position, geodetic or from a local origin, is known well enough. False
   * for a ground vehicle whose speed is not measured, however small sigma still is, because the
   * vehicle may have stopped.
   */
  public boolean hasPosition() {
    boolean isSure = Math.max(positionSigmaM(0), positionSigmaM(1)) <= tuning.lostSigmaM();
    boolean isGuess =
        tuning.domain() == MotionDomain.GROUND
            && !InertialInput.isAided(s, InertialInput.UNAIDED_S);
    return (s.hasPlace || s.hasLocal) && isSure && !isGuess;
  }

  /** Whether the altitude is known well enough. */
  public boolean hasAltitude() {
    return s.hasAltitude && sigma(FilterState.POSITION + 2) <= tuning.lostSigmaM();
  }

  /** Whether the heading is known. */
  public boolean hasHeading() {
    return s.hasHeading && attitudeSigmas[2] < Math.PI / 2.0;
  }

  /** Whether any source measures roll and pitch. */
  public boolean hasTilt() {
    return s.hasTilt;
  }

  /** Whether wind or current is estimated. */
  public boolean hasFlow() {
    return s.hasFlow;
  }

  /** Whether specific forces drive the velocity. */
  public boolean isStrapdown() {
    return s.isStrapdown;
  }

  /** Latitude [deg]. */
  public double latitudeDeg() {
    return Math.toDegrees(s.x[FilterState.LATITUDE]);
  }

  /** Longitude [deg]. */
  public double longitudeDeg() {
    return Math.toDegrees(s.x[FilterState.LONGITUDE]);
  }

  /** Altitude [m]. */
  public double altitudeM() {
    return s.x[FilterState.ALTITUDE];
  }

  /** North, east or down from the local origin [m]. */
  public double localM(int axis) {
    return s.x[FilterState.NORTH + axis];
  }

  /** Standard deviation of the position, north, east or down [m]. */
  public double positionSigmaM(int axis) {
    double sigma = sigma(FilterState.POSITION + axis);
    double lacks = axis == 2 ? s.x[FilterState.ALTITUDE_ERROR] : 0.0;
    return lacks > 0.0 ? Math.sqrt(sigma * sigma + lacks) : sigma;
  }

  /** Velocity north, east or down [m/s]. */
  public double velocityMps(int axis) {
    return s.x[FilterState.V + axis];
  }

  /** Standard deviation of the velocity [m/s]. */
  public double velocitySigmaMps(int axis) {
    return sigma(FilterState.VELOCITY + axis);
  }

  /** Roll [rad]. */
  public double phi() {
    return Quaternions.phi(r);
  }

  /** Pitch [rad]. */
  public double theta() {
    return Quaternions.theta(r);
  }

  /** Heading [rad, 0…2π). */
  public double psi() {
    double psi = Quaternions.psi(r);
    return psi < 0.0 ? psi + 2.0 * Math.PI : psi;
  }

  /** Standard deviation of roll, pitch or heading [rad]. */
  public double attitudeSigma(int axis) {
    return attitudeSigmas[axis];
  }

  /** Angular rate about a BODY_FRD axis [rad/s]. */
  public double bodyRate(int axis) {
    return s.x[FilterState.W + axis];
  }

  /** Standard deviation of the angular rate [rad/s]. */
  public double bodyRateSigma(int axis) {
    int bias = FilterState.GYRO_BIAS + axis;
    double own = s.variance(FilterState.RATE + axis);
    return Math.sqrt(own + (s.isInertial ? s.variance(bias) : 0.0));
  }

  /** Rate of the heading [rad/s] (Stevens and Lewis, 2nd ed., section 1.3). */
  public double headingRate() {
    double cos = Math.sqrt(r[7] * r[7] + r[8] * r[8]);
    double[] x = s.x;
    double turn = r[7] * x[FilterState.W + 1] + r[8] * x[FilterState.W + 2];
    return cos < VERTICAL ? 0.0 : turn / (cos * cos);
  }

  /** Wind or current, north or east component of the direction it flows to [m/s]. */
  public double flowMps(int axis) {
    return s.x[FilterState.FLOW_NORTH + axis];
  }

  /** Standard deviation of wind or current [m/s]. */
  public double flowSigmaMps(int axis) {
    return sigma(FilterState.FLOW + axis);
  }

  /** Relative scale error of the wheel speeds; positive if they read too high. */
  public double wheelScale() {
    return s.x[FilterState.WHEEL_SCALE];
  }

  /** Acceleration over ground [m/s²], north, east or down, as of the newest specific force. */
  public double accelerationMps2(int axis) {
    double sum = axis == 2 ? s.gravity() : 0.0;
    for (int k = 0; k < 3; k++) {
      sum += r[3 * axis + k] * (s.x[FilterState.FORCE + k] - s.x[FilterState.BF + k]);
    }
    return sum;
  }

  /** Speeds through the fluid along BODY_FRD and their standard deviations [m/s]. */
  public void fluid(double[] speeds, double[] sigmas) {
    model.fluid(s, speeds, sigmas);
  }

  /** Covariance of position and velocity errors (north, east, down), for consistency tests. */
  double covariance(int row, int column) {
    return s.p.data[row * FilterState.N + column];
  }

  private double sigma(int i) {
    return Math.sqrt(Math.max(0.0, s.variance(i)));
  }
}
