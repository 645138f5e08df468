package org.u2sa.sim.ground;

import java.util.Objects;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.FixedStep;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/**
 * Rigid body on a plane or gentle slopes, common to all ground vehicles. Axes: x forward, y right,
 * yaw clockwise positive seen from above. Velocities refer to the centre of gravity, the position
 * to the reference point.
 */
abstract class PlanarVehicle implements GroundVehicle {
  static final int EAST = 0;
  static final int NORTH = 1;
  static final int PSI = 2; // not wrapped
  static final int U = 3; // forward [m/s]
  static final int V = 4; // right [m/s]
  static final int R = 5; // [rad/s]
  static final int FREE = 6; // index of the subclass's first state

  static final double TICK_S = 1.0 / TICKS_PER_SECOND;
  static final double FRICTION_FULL_MPS = 0.05; // below this, drag of free wheels fades out

  static final double MIN_LOAD_N = 1.0; // load of a wheel about to lift

  private static final double TURN_RAD = 2.0 * Math.PI;
  private static final double STILL = 1e-4; // [m/s], [rad/s]
  private static final double CALM = 1e-2; // [m/s²], [rad/s²]

  final double[] s;
  final Battery battery;
  Surface surface;
  private final double massKg;
  private final double yawInertiaKgM2;
  private final double referenceX; // relative to the centre of gravity
  private final double referenceY;
  private final RungeKutta integrator;
  private final FastestRate fastest;
  private final RungeKutta.Motion motion = this::derivatives;
  private final double[] rate;
  private double pushEast;
  private double pushNorth;
  private double pushTurn;
  private World world = World.at(new Geodetic(0.0, 0.0, 0.0));
  private Terrain terrain = world.terrain();
  private double pullEast; // gravity along the slope [N], held during a tick
  private double pullNorth;
  private final FixedStep steps = new FixedStep(TICKS_PER_SECOND);
  private final Runnable tick = this::tick;
  private final double[] before = new double[FREE]; // previous tick
  private DriveCommand held = DriveCommand.none();
  private boolean resting;
  private final Direction direction = new Direction();
  private double sinPsi; // at the start of the tick
  private double cosPsi;

  PlanarVehicle(GroundStart start, int size, Chassis chassis, Battery battery) {
    s = new double[size];
    s[EAST] = start.eastM();
    s[NORTH] = start.northM();
    s[PSI] = start.headingRad();
    System.arraycopy(s, 0, before, 0, FREE);
    direction.turn(s[PSI]);
    sinPsi = direction.sin();
    cosPsi = direction.cos();
    surface = world.surface();
    rate = new double[size];
    integrator = new RungeKutta(size);
    massKg = chassis.massKg();
    yawInertiaKgM2 = chassis.yawInertiaKgM2();
    fastest = new FastestRate(massKg, yawInertiaKgM2);
    referenceX = -chassis.cogAheadM();
    referenceY = -chassis.cogRightM();
    this.battery = battery;
  }

  /** Sets commands, ground and battery for a tick. */
  abstract void prepare(DriveCommand command);

  /**
   * Adds the subclass's forces with {@link #force} and computes the derivatives of its own states.
   */
  abstract void derive(double[] state, double[] rates);

  /**
   * Sets wheel loads for the slope.
   *
   * @param pressing fraction of the weight normal to the ground, 1 on level ground
   * @param forward fraction of the weight along the vehicle, negative uphill
   * @param right fraction of the weight to the right
   */
  abstract void lean(double pressing, double forward, double right);

  /** Adds the wheels, tyres and other states, as prepared for a tick. */
  abstract void bound(FastestRate rate);

  /** Called after a tick's integration. */
  abstract void settle();

  /** Whether it is undriven. */
  abstract boolean idle();

  abstract void halt();

  // force sums of one evaluation
  private double forward;
  private double right;
  private double turn;

  /** Adds a force in vehicle axes at a position relative to the centre of gravity. */
  final void force(double x, double y, double forwardN, double rightN) {
    forward += forwardN;
    right += rightN;
    turn += x * rightN - y * forwardN;
  }

  final void moment(double nm) {
    turn += nm;
  }

  /** Derives a driven wheel, whose state is {@code at} this index, and adds its force. */
  final void rolling(DrivenWheel wheel, int at, double[] state, double[] rates) {
    double along = state[U] - state[R] * wheel.y;
    double across = state[V] + state[R] * wheel.x;
    wheel.derive(state, at, along, across, state[R], rates);
    force(wheel.x, wheel.y, wheel.forceAlong, wheel.forceAcross);
  }

  @Override
  public final void step(DriveCommand command, double dtS) {
    held = Objects.requireNonNull(command, "command");
    step(dtS);
  }

  @Override
  public final void step(double dtS) {
    steps.step(dtS, tick);
  }

  @Override
  public final void command(String actuator, double value) {
    int input = actuators().indexOf(actuator);
    if (input < 0) {
      throw new IllegalArgumentException(
          "actuator \"" + actuator + "\": expected one of " + actuators());
    }
    held = new DriveCommand(input == 0 ? value : held.first(), input == 1 ? value : held.second());
  }

  private void tick() {
    System.arraycopy(s, 0, before, 0, FREE);
    direction.turn(s[PSI]);
    sinPsi = direction.sin();
    cosPsi = direction.cos();
    if (terrain != Terrain.flat()) {
      meetSlope();
    }
    prepare(held);
    boolean left = idle() && !pushed();
    if (resting && left) {
      return;
    }
    resting = false;
    fastest.begin();
    bound(fastest);
    integrator.step(motion, s, TICK_S, fastest.steps(TICK_S));
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
    pullEast = massKg * Gravity.STANDARD_MPS2 * shareEast;
    pullNorth = massKg * Gravity.STANDARD_MPS2 * shareNorth;
    lean(
        pressing,
        shareEast * sinPsi + shareNorth * cosPsi,
        shareEast * cosPsi - shareNorth * sinPsi);
  }

  private boolean still() {
    return Math.abs(s[U]) < STILL && Math.abs(s[V]) < STILL && Math.abs(s[R]) < STILL;
  }

  private void derivatives(double[] state, double[] rates) {
    direction.turn(state[PSI]);
    double sin = direction.sin();
    double cos = direction.cos();
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

  /** State of wheels, motors and battery. */
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
        steps.timeS(),
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
  public final void enter(World newWorld) {
    world = Objects.requireNonNull(newWorld, "world");
    surface = world.surface();
    Terrain met = world.terrain().underWheels();
    if (!terrain.equals(met)) {
      terrain = met;
      pullEast = 0.0;
      pullNorth = 0.0;
      lean(1.0, 0.0, 0.0);
    }
  }

  @Override
  public final World world() {
    return world;
  }

  @Override
  public final OptionalDouble energyJ() {
    return OptionalDouble.of(battery.givenJ());
  }

  @Override
  public final void charge(double charge) {
    battery.charge(charge);
  }

  @Override
  public final VehicleTruth truth() {
    direction.turn(s[PSI]);
    double sin = direction.sin();
    double cos = direction.cos();
    Attitude now = attitude(s, sin, cos);
    Attitude then = attitude(before, sinPsi, cosPsi);
    Point velocity = velocity(s, sin, cos);
    Point old = velocity(before, sinPsi, cosPsi);
    Point euler =
        Point.of((now.phi() - then.phi()) / TICK_S, (now.theta() - then.theta()) / TICK_S, s[R]);
    return new VehicleTruth(
        steps.timeS(),
        Point.of(s[EAST], s[NORTH], terrain.heightM(s[EAST], s[NORTH])),
        now,
        velocity,
        now.bodyRates(euler),
        Point.of(
            (velocity.x() - old.x()) / TICK_S,
            (velocity.y() - old.y()) / TICK_S,
            (velocity.z() - old.z()) / TICK_S));
  }

  /** Attitude on the slope: the slope's axes rotated by the heading. */
  private Attitude attitude(double[] state, double sin, double cos) {
    double heading = state[PSI] - TURN_RAD * StrictMath.floor(state[PSI] / TURN_RAD);
    double riseEast = terrain.riseEast(state[EAST], state[NORTH]);
    double riseNorth = terrain.riseNorth(state[EAST], state[NORTH]);
    double ahead = riseEast * sin + riseNorth * cos;
    double aside = riseEast * cos - riseNorth * sin; // rise to the right: left wing down
    if (ahead == 0.0 && aside == 0.0) {
      return new Attitude(-aside, ahead, heading); // level, and the arcs of 0 are 0
    }
    double pitch = StrictMath.atan(ahead);
    return new Attitude(-StrictMath.atan(aside * StrictMath.cos(pitch)), pitch, heading);
  }

  /** Velocity of the reference point: east, north, up [m/s]. */
  private Point velocity(double[] state, double sin, double cos) {
    double u = state[U] - state[R] * referenceY;
    double v = state[V] + state[R] * referenceX;
    double east = u * sin + v * cos;
    double north = u * cos - v * sin;
    double climb =
        terrain.riseEast(state[EAST], state[NORTH]) * east
            + terrain.riseNorth(state[EAST], state[NORTH]) * north;
    return Point.of(east, north, climb);
  }

  /** East of a point given relative to the centre of gravity, at the start of the tick [m]. */
  final double eastOf(double x, double y) {
    double ahead = x - referenceX;
    double aside = y - referenceY;
    return s[EAST] + ahead * sinPsi + aside * cosPsi;
  }

  /** North of a point given relative to the centre of gravity, at the start of the tick [m]. */
  final double northOf(double x, double y) {
    double ahead = x - referenceX;
    double aside = y - referenceY;
    return s[NORTH] + ahead * cosPsi - aside * sinPsi;
  }

  /** Drag of a free wheel: full friction when rolling, fading to zero at rest. */
  static double fading(double speedMps) {
    return Math.max(-1.0, Math.min(1.0, speedMps / FRICTION_FULL_MPS));
  }
}
