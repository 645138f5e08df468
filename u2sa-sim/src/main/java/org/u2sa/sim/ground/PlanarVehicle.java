package org.u2sa.sim.ground;

import java.util.Objects;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.motion.Motion;
import org.u2sa.sim.motion.RungeKutta;

/**
 * A rigid body on a plane, or on gentle slopes: what all ground vehicles share. Axes as in the
 * aircraft: x forward, y right, turns clockwise positive, seen from above. Velocities are those of
 * the centre of gravity, the position is that of the reference point.
 */
abstract class PlanarVehicle implements GroundVehicle {
  static final int EAST = 0;
  static final int NORTH = 1;
  static final int PSI = 2; // not wrapped
  static final int U = 3; // forward [m/s]
  static final int V = 4; // right [m/s]
  static final int R = 5; // [rad/s]
  static final int FREE = 6; // first of the vehicle's own states

  static final double TICK_S = 1.0 / TICKS_PER_SECOND;
  static final double GRAVITY_MPS2 = 9.80665;
  static final double FRICTION_FULL_MPS = 0.05; // free wheels: below, their drag fades

  static final double LEAST_LOAD_N = 1.0; // of a wheel that would lift

  private static final double LONGEST_STEP_S = 60.0;
  private static final double TURN_RAD = 2.0 * Math.PI;
  private static final double STILL = 1e-4; // [m/s], [rad/s]
  private static final double CALM = 1e-2; // [m/s²], [rad/s²]

  final double[] s;
  final Battery battery;
  Surface surface = Surface.lawn();
  private final double massKg;
  private final double yawInertiaKgM2;
  private final double referenceX; // by the centre of gravity
  private final double referenceY;
  private final RungeKutta integrator;
  private final Motion motion = this::derivatives;
  private final double[] rate;
  private double pushEast;
  private double pushNorth;
  private double pushTurn;
  private Terrain terrain = Terrain.flat();
  private double pullEast; // gravity along the slope [N], held during a tick
  private double pullNorth;
  private long ticks;
  private double dueS;
  private boolean resting;
  private double sinPsi;
  private double cosPsi;

  PlanarVehicle(GroundStart start, int size, Chassis chassis, Battery battery) {
    s = new double[size];
    s[EAST] = start.eastM();
    s[NORTH] = start.northM();
    s[PSI] = start.headingRad();
    rate = new double[size];
    integrator = new RungeKutta(size);
    massKg = chassis.massKg();
    yawInertiaKgM2 = chassis.yawInertiaKgM2();
    referenceX = -chassis.cogAheadM();
    referenceY = -chassis.cogRightM();
    this.battery = battery;
  }

  /** Takes commands, ground and battery for a tick. */
  abstract void prepare(DriveCommand command);

  /** Adds the vehicle's own forces with {@link #force} and gives its own states' rates. */
  abstract void derive(double[] state, double[] rates);

  /**
   * Takes what the slope makes of the wheels' loads.
   *
   * @param pressing share of the weight that presses on the ground, 1 on level ground
   * @param forward share of the weight that pulls ahead: negative uphill
   * @param right share of the weight that pulls to the right
   */
  abstract void lean(double pressing, double forward, double right);

  /** After a tick's integration. */
  abstract void settle();

  /** Whether nothing drives it. */
  abstract boolean idle();

  abstract void halt();

  // sums of one evaluation
  private double forward;
  private double right;
  private double turn;

  /** Adds a force in the vehicle's axes at a place by its centre of gravity. */
  final void force(double x, double y, double forwardN, double rightN) {
    forward += forwardN;
    right += rightN;
    turn += x * rightN - y * forwardN;
  }

  final void moment(double nm) {
    turn += nm;
  }

  @Override
  public final void step(DriveCommand command, double dtS) {
    Objects.requireNonNull(command, "command");
    if (!(dtS > 0.0 && dtS <= LONGEST_STEP_S)) {
      throw new IllegalArgumentException("dt: " + dtS + " s is outside 0…" + LONGEST_STEP_S + " s");
    }
    dueS += dtS;
    long count = (long) StrictMath.floor(dueS * TICKS_PER_SECOND + 1e-6);
    dueS -= count * TICK_S;
    for (long i = 0; i < count; i++) {
      tick(command);
    }
  }

  private void tick(DriveCommand command) {
    ticks++;
    sinPsi = StrictMath.sin(s[PSI]);
    cosPsi = StrictMath.cos(s[PSI]);
    if (terrain != Terrain.flat()) {
      meetSlope();
    }
    prepare(command);
    boolean left = idle() && !pushed();
    if (resting && left) {
      return;
    }
    resting = false;
    integrator.step(motion, s, TICK_S);
    settle();
    if (left && still()) {
      derivatives(s, rate);
      if (Math.abs(rate[U]) < CALM && Math.abs(rate[V]) < CALM && Math.abs(rate[R]) < CALM) {
        s[U] = 0.0;
        s[V] = 0.0;
        s[R] = 0.0;
        halt();
        resting = true;
      }
    }
  }

  private void meetSlope() {
    double east = eastOf(0.0, 0.0);
    double north = northOf(0.0, 0.0);
    double riseEast = terrain.riseEast(east, north);
    double riseNorth = terrain.riseNorth(east, north);
    double pressing = 1.0 / StrictMath.sqrt(1.0 + riseEast * riseEast + riseNorth * riseNorth);
    double shareEast = -riseEast * pressing;
    double shareNorth = -riseNorth * pressing;
    pullEast = massKg * GRAVITY_MPS2 * shareEast;
    pullNorth = massKg * GRAVITY_MPS2 * shareNorth;
    lean(
        pressing,
        shareEast * sinPsi + shareNorth * cosPsi,
        shareEast * cosPsi - shareNorth * sinPsi);
  }

  private boolean still() {
    return Math.abs(s[U]) < STILL && Math.abs(s[V]) < STILL && Math.abs(s[R]) < STILL;
  }

  private void derivatives(double[] state, double[] rates) {
    double sin = StrictMath.sin(state[PSI]);
    double cos = StrictMath.cos(state[PSI]);
    double east = pushEast + pullEast;
    double north = pushNorth + pullNorth;
    forward = east * sin + north * cos;
    right = east * cos - north * sin;
    turn = pushTurn;
    derive(state, rates);
    double u = state[U] - state[R] * referenceY;
    double v = state[V] + state[R] * referenceX;
    rates[EAST] = u * sin + v * cos;
    rates[NORTH] = u * cos - v * sin;
    rates[PSI] = state[R];
    rates[U] = forward / massKg + state[R] * state[V];
    rates[V] = right / massKg - state[R] * state[U];
    rates[R] = turn / yawInertiaKgM2;
  }

  /** State of what turns and flows. */
  final GroundState state(
      double leftSpin,
      double rightSpin,
      double leftAngle,
      double rightAngle,
      double steerRad,
      double leftA,
      double rightA) {
    double heading = s[PSI] - TURN_RAD * StrictMath.floor(s[PSI] / TURN_RAD);
    return new GroundState(
        (double) ticks / TICKS_PER_SECOND,
        s[EAST],
        s[NORTH],
        heading < TURN_RAD ? heading : 0.0,
        s[U] - s[R] * referenceY,
        s[V] + s[R] * referenceX,
        s[R],
        leftSpin,
        rightSpin,
        leftAngle,
        rightAngle,
        steerRad,
        leftA,
        rightA,
        battery.volts(),
        battery.charge());
  }

  @Override
  public final void push(double eastN, double northN, double turnNm) {
    pushEast = Arguments.requireFinite("push east", eastN);
    pushNorth = Arguments.requireFinite("push north", northN);
    pushTurn = Arguments.requireFinite("push turn", turnNm);
  }

  private boolean pushed() {
    boolean level = pullEast == 0.0 && pullNorth == 0.0;
    return !level || pushEast != 0.0 || pushNorth != 0.0 || pushTurn != 0.0;
  }

  @Override
  public final void terrain(Terrain newTerrain) {
    terrain = Objects.requireNonNull(newTerrain, "terrain");
    pullEast = 0.0;
    pullNorth = 0.0;
    lean(1.0, 0.0, 0.0);
  }

  @Override
  public final void charge(double charge) {
    battery.charge(charge);
  }

  @Override
  public final void ground(Surface newSurface) {
    surface = Objects.requireNonNull(newSurface, "surface");
  }

  /** East of a place given by the centre of gravity, at the tick's beginning [m]. */
  final double eastOf(double x, double y) {
    double ahead = x - referenceX;
    double aside = y - referenceY;
    return s[EAST] + ahead * sinPsi + aside * cosPsi;
  }

  /** North of a place given by the centre of gravity, at the tick's beginning [m]. */
  final double northOf(double x, double y) {
    double ahead = x - referenceX;
    double aside = y - referenceY;
    return s[NORTH] + ahead * cosPsi - aside * sinPsi;
  }

  /** Drag of a free wheel: full friction when it rolls, fading to none at rest. */
  static double fading(double speedMps) {
    return Math.max(-1.0, Math.min(1.0, speedMps / FRICTION_FULL_MPS));
  }
}
