package org.u2sa.estimation.fusion;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.u2sa.estimation.delay.InertialPath;
import org.u2sa.estimation.delay.MotionDelay;
import org.u2sa.estimation.rotation.MotionHeading;

/**
 * Nominal state, error covariance and source statistics at one time. Flat arrays, so that a state
 * is saved and restored by copying them.
 *
 * <p>Error state, 37 numbers: position (north, east, down [m]), velocity (the same axes [m/s]),
 * attitude (a small rotation about north, east and down [rad]: Solà 2017, section 7, global angular
 * errors), gyroscope bias [rad/s], accelerometer bias [m/s²] and angular rate [rad/s] (each along
 * BODY_FRD), wind or current (north, east [m/s]), wheel-speed scale, {@link PersistentErrors} of
 * sources (positions, north and east [m]; headings [rad]), {@link DelayErrors} of position sources
 * [s], constant error of speeds over ground measured along BODY_FRD [m/s], heading at which a
 * velocity log is mounted [rad].
 *
 * <p>The nominal position is geodetic, in double precision, once a source provides one. Error
 * vectors are along north, east and down at the vehicle itself, so there is no tangent plane with a
 * limited range. The position relative to the start (north, east, down) is kept as well.
 */
final class FilterState {
  static final int POSITION_SOURCES = 3; // with persistent errors
  static final int HEADING_SOURCES = 3;
  static final int PERSISTENT_SLOTS = POSITION_SOURCES + HEADING_SOURCES;
  static final int PERSISTENT_STATES = 2 * POSITION_SOURCES + HEADING_SOURCES;
  static final int DELAY_SLOTS = 3; // position sources with an estimated delay
  static final int N = 21 + PERSISTENT_STATES + DELAY_SLOTS + 4;
  static final int NO_SOURCE = -1;
  static final int RESUMED = -2; // unknown source with known biases
  static final int POSITION = 0;
  static final int VELOCITY = 3;
  static final int ATTITUDE = 6;
  static final int GYRO_BIAS = 9;
  static final int FORCE_BIAS = 12;
  static final int RATE = 15;
  static final int FLOW = 18;
  static final int SCALE = 20;
  static final int PERSISTENT = 21;
  static final int DELAY = PERSISTENT + PERSISTENT_STATES;
  static final int SPEED_BIAS = DELAY + DELAY_SLOTS;
  static final int LOG_YAW = SPEED_BIAS + 3;

  // Nominal state: indices into x.
  static final int LATITUDE = 0; // rad
  static final int LONGITUDE = 1; // rad
  static final int ALTITUDE = 2; // m
  static final int NORTH = 3; // m from the local origin; then east, down
  static final int V = 6;
  static final int Q = 9;
  static final int BG = 13;
  static final int BF = 16;
  static final int W = 19;
  static final int FLOW_NORTH = 22; // then east
  static final int WHEEL_SCALE = 24;
  static final int GYRO = 25; // newest inertial input
  static final int FORCE = 28;
  static final int GYRO_DENSITY = 31; // variance times interval [rad²/s]
  static final int FORCE_DENSITY = 32; // m²/s³
  static final int INPUT_INTERVAL = 33; // s, running mean
  static final int LEVELLING = 34; // sum of specific forces during levelling, three axes
  static final int LEVELLED = 37; // number of summands
  static final int PERSISTENT_ERRORS = 38; // in the order of the error state
  static final int PERSISTENT_VARIANCE = PERSISTENT_ERRORS + PERSISTENT_STATES; // by slot
  static final int DELAYS = PERSISTENT_VARIANCE + PERSISTENT_SLOTS; // s, by slot
  static final int STEADY_V = DELAYS + DELAY_SLOTS; // velocity before a change: north, east [m/s]
  static final int SLOPE = STEADY_V + 2; // sine of the pitch to which the wheel scale belongs
  static final int SPEED_ERROR = SLOPE + 1; // three axes
  static final int ALTITUDE_ERROR = SPEED_ERROR + 3; // variance that P lacks, see SourceTrust [m²]
  static final int LOG_TURN = ALTITUDE_ERROR + 1; // of a velocity log, clockwise [rad]
  private static final int SIZE = LOG_TURN + 1;

  private static final double A = 6_378_137.0; // semi-major axis [m], WGS-84 (NIMA TR8350.2)
  private static final double E2 = 6.694379990141316e-3; // first eccentricity squared
  private static final double EQUATOR_MPS2 = 9.7803253359; // normal gravity (Somigliana)
  private static final double EQUATOR_TO_POLE = 1.931852652458e-3;
  private static final double POLE = 1e-6; // minimum cosine of latitude to divide by

  final double[] x = new double[SIZE];
  final DMatrixRMaj p = new DMatrixRMaj(N, N);
  final double[] search = new double[HeadingSearch.SIZE];
  final double[] motion = new double[MotionHeading.SIZE];
  final double[] path = new double[InertialPath.SIZE];
  final double[] delays = new double[DELAY_SLOTS * MotionDelay.SIZE];
  final boolean[] isDelayShown = new boolean[DELAY_SLOTS]; // by velocities
  final double[] sightings = new double[36]; // see RepeatedSightings
  double[] trust = new double[0]; // SourceTrust's numbers
  long micros;
  boolean isStarted;
  boolean hasPlace;
  boolean hasAltitude;
  boolean hasLocal;
  boolean hasHeading;
  boolean hasTilt;
  boolean hasFlow;
  boolean isInertial; // angular rates drive the attitude
  boolean isStrapdown; // and specific forces the velocity
  long startedMicros;
  long gyroMicros; // time of the newest inertial input
  long forceMicros;
  int gyroSource = NO_SOURCE;
  int speedSource = NO_SOURCE; // source whose speed drives the prediction, see MotionInput
  int turnSource = NO_SOURCE;
  double heldMps; // last value measured by it
  double heldRadPerS;
  long heldMicros; // time of that speed
  long speedUntilMicros; // expiry unless renewed
  long turnUntilMicros;
  long positionMicros; // time of the newest measurement used, also below
  long velocityMicros;
  long headingMicros;
  long tiltMicros;
  long fluidMicros;
  long acrossMicros = Long.MIN_VALUE / 2; // of a speed sideways, through the fluid or over ground
  long constraintMicros;
  long movingMicros; // when the direction of motion became usable as heading
  long turnedMicros = Long.MIN_VALUE / 2; // when wheels last measured a turn
  boolean slipsInTurns; // a heading has contradicted a turn that only wheels measured
  long slidingMicros; // since when the no-sideslip constraint is refused; 0: it is met
  long accusedMicros; // when an inertial source was found faulty; 0: never
  long reopenedMicros = Long.MIN_VALUE / 2; // when the velocity was lost; until it is measured
  long resets;
  final int[] persistentSource = unassigned(PERSISTENT_SLOTS); // by slot
  final int[] delaySource = unassigned(DELAY_SLOTS); // by slot

  FilterState() {
    x[Q] = 1.0;
  }

  private static int[] unassigned(int slots) {
    int[] sources = new int[slots];
    Arrays.fill(sources, NO_SOURCE);
    return sources;
  }

  /** Number of delay slots that have a source; they are assigned in order. */
  private int assignedSlots() {
    int count = 0;
    while (count < DELAY_SLOTS && delaySource[count] != NO_SOURCE) {
      count++;
    }
    return count;
  }

  void copyFrom(FilterState o) {
    System.arraycopy(o.x, 0, x, 0, SIZE);
    System.arraycopy(o.p.data, 0, p.data, 0, N * N);
    System.arraycopy(o.search, 0, search, 0, search.length);
    System.arraycopy(o.motion, 0, motion, 0, motion.length);
    System.arraycopy(o.path, 0, path, 0, path.length);
    System.arraycopy(o.delays, 0, delays, 0, o.assignedSlots() * MotionDelay.SIZE);
    System.arraycopy(o.isDelayShown, 0, isDelayShown, 0, DELAY_SLOTS);
    System.arraycopy(o.sightings, 0, sightings, 0, sightings.length);
    if (trust.length < o.trust.length) {
      trust = new double[o.trust.length];
    }
    System.arraycopy(o.trust, 0, trust, 0, o.trust.length);
    Arrays.fill(trust, o.trust.length, trust.length, 0.0);
    micros = o.micros;
    isStarted = o.isStarted;
    hasPlace = o.hasPlace;
    hasAltitude = o.hasAltitude;
    hasLocal = o.hasLocal;
    hasHeading = o.hasHeading;
    hasTilt = o.hasTilt;
    hasFlow = o.hasFlow;
    isInertial = o.isInertial;
    isStrapdown = o.isStrapdown;
    reopenedMicros = o.reopenedMicros;
    startedMicros = o.startedMicros;
    gyroMicros = o.gyroMicros;
    forceMicros = o.forceMicros;
    gyroSource = o.gyroSource;
    speedSource = o.speedSource;
    turnSource = o.turnSource;
    heldMps = o.heldMps;
    heldRadPerS = o.heldRadPerS;
    heldMicros = o.heldMicros;
    speedUntilMicros = o.speedUntilMicros;
    turnUntilMicros = o.turnUntilMicros;
    positionMicros = o.positionMicros;
    velocityMicros = o.velocityMicros;
    headingMicros = o.headingMicros;
    tiltMicros = o.tiltMicros;
    fluidMicros = o.fluidMicros;
    acrossMicros = o.acrossMicros;
    constraintMicros = o.constraintMicros;
    movingMicros = o.movingMicros;
    turnedMicros = o.turnedMicros;
    slipsInTurns = o.slipsInTurns;
    slidingMicros = o.slidingMicros;
    accusedMicros = o.accusedMicros;
    resets = o.resets;
    System.arraycopy(o.persistentSource, 0, persistentSource, 0, PERSISTENT_SLOTS);
    System.arraycopy(o.delaySource, 0, delaySource, 0, DELAY_SLOTS);
  }

  double variance(int i) {
    return p.data[i * N + i];
  }

  /** Resets an error state to the given variance, uncorrelated with all others. */
  void isolate(int i, double variance) {
    for (int k = 0; k < N; k++) {
      p.data[i * N + k] = 0.0;
      p.data[k * N + i] = 0.0;
    }
    p.data[i * N + i] = variance;
  }

  /** Whether a measured speed drives the prediction, see {@link MotionInput}. */
  boolean hasSpeedInput() {
    return speedSource != NO_SOURCE && !isStrapdown;
  }

  /** Whether a measured turn rate drives the prediction. */
  boolean hasTurnInput() {
    return turnSource != NO_SOURCE && !isInertial;
  }

  /** Gravity [m/s²] (WGS-84, NIMA TR8350.2, section 4). */
  double gravity() {
    double sin = hasPlace ? StrictMath.sin(x[LATITUDE]) : Math.sqrt(0.5);
    double sin2 = sin * sin;
    return EQUATOR_MPS2 * (1.0 + EQUATOR_TO_POLE * sin2) / Math.sqrt(1.0 - E2 * sin2);
  }

  /** Meridian radius of curvature at the vehicle's altitude [m]. */
  double northRadiusM() {
    return northRadiusM(StrictMath.sin(x[LATITUDE]));
  }

  private double northRadiusM(double sinLatitude) {
    double w2 = 1.0 - E2 * sinLatitude * sinLatitude;
    return A * (1.0 - E2) / (w2 * Math.sqrt(w2)) + x[ALTITUDE];
  }

  /** Distance from the earth's axis [m], i.e. length of a radian of longitude. */
  double axisDistanceM() {
    return axisDistanceM(StrictMath.sin(x[LATITUDE]));
  }

  private double axisDistanceM(double sinLatitude) {
    double radius = A / Math.sqrt(1.0 - E2 * sinLatitude * sinLatitude) + x[ALTITUDE];
    return radius * Math.max(POLE, StrictMath.cos(x[LATITUDE]));
  }

  /** Moves the nominal position [m]. */
  void move(double north, double east, double down) {
    x[NORTH] += north;
    x[NORTH + 1] += east;
    x[NORTH + 2] += down;
    if (hasPlace) {
      double sinLatitude = StrictMath.sin(x[LATITUDE]);
      double northRadius = northRadiusM(sinLatitude);
      double axisDistance = axisDistanceM(sinLatitude);
      x[LATITUDE] += north / northRadius;
      x[LONGITUDE] = Math.IEEEremainder(x[LONGITUDE] + east / axisDistance, 2.0 * Math.PI);
    }
    x[ALTITUDE] -= down;
  }
}
