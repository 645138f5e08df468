package org.u2sa.sim.ground;

import java.util.List;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.world.Footprint;

/**
 * Differential-drive vehicle with a front castor: the Mini-Molle of thesis 4.6.3. Models tyre creep
 * and slip, scrubbing in turns and battery load. Slopes transfer weight between the wheels;
 * acceleration does not. A wheel about to lift carries 1 N.
 */
public final class DifferentialVehicle extends PlanarVehicle {
  private static final int LEFT = FREE;
  private static final int RIGHT = LEFT + DrivenWheel.SIZE;
  private static final int CASTOR = RIGHT + DrivenWheel.SIZE;
  private static final int SIZE = CASTOR + 1;
  private static final double HALF_TYRE_M = 0.03;

  private final DifferentialParameters p;
  private final Chassis chassis;
  private final double mismatch;
  private final DrivenWheel left;
  private final DrivenWheel right;
  private final Castor castor;
  private final Footprint footprint;

  /** Creates a vehicle at the origin, facing north, on a lawn. */
  public DifferentialVehicle(DifferentialParameters parameters) {
    this(parameters, GroundStart.atOrigin());
  }

  /**
   * Creates a vehicle at rest on a lawn, with a full battery.
   *
   * @throws IllegalArgumentException if the payload lifts a wheel
   */
  public DifferentialVehicle(DifferentialParameters p, GroundStart start) {
    this(p, start, outlineOfWheels(p));
  }

  /**
   * Like the other constructor, with a collision outline of its own.
   *
   * @throws IllegalArgumentException if the payload lifts a wheel
   */
  public DifferentialVehicle(DifferentialParameters p, GroundStart start, Footprint footprint) {
    this(
        p,
        start,
        footprint,
        Chassis.of(p.massKg(), p.yawInertiaKgM2(), p.cogAheadM(), p.payload()));
  }

  private DifferentialVehicle(
      DifferentialParameters p, GroundStart start, Footprint footprint, Chassis chassis) {
    super(start, SIZE, chassis, new Battery(p.battery()));
    this.footprint = footprint;
    this.p = p;
    this.chassis = chassis;
    mismatch = p.mismatch();
    double weight = chassis.massKg() * Gravity.STANDARD_MPS2;
    double castorN = weight * chassis.cogAheadM() / p.castorAheadM();
    double axleN = weight - castorN;
    double shiftN = weight * chassis.cogRightM() / p.trackM(); // load transfer from left to right
    requireLoad("castor", castorN);
    requireLoad("left wheel", axleN / 2.0 - shiftN);
    requireLoad("right wheel", axleN / 2.0 + shiftN);
    double x = -chassis.cogAheadM();
    left = wheel(p, x, -p.trackM() / 2.0 - chassis.cogRightM(), axleN / 2.0 - shiftN);
    right = wheel(p, x, p.trackM() / 2.0 - chassis.cogRightM(), axleN / 2.0 + shiftN);
    castor = new Castor(x + p.castorAheadM(), -chassis.cogRightM(), p.castorTrailM(), castorN);
  }

  private static Footprint outlineOfWheels(DifferentialParameters p) {
    return Footprint.rectangle(
        p.castorAheadM() + HALF_TYRE_M,
        p.wheelRadiusM(),
        p.trackM() + 2.0 * HALF_TYRE_M,
        0.0,
        2.0 * p.cogHeightM());
  }

  @Override
  void lean(double pressing, double forward, double right) {
    double weight = chassis.massKg() * Gravity.STANDARD_MPS2;
    double ahead = pressing * chassis.cogAheadM() + forward * p.cogHeightM();
    double aside = pressing * chassis.cogRightM() + right * p.cogHeightM();
    double castorN = weight * ahead / p.castorAheadM();
    double axleN = weight * pressing - castorN;
    double shiftN = weight * aside / p.trackM();
    castor.load(Math.max(MIN_LOAD_N, castorN));
    left.load(Math.max(MIN_LOAD_N, axleN / 2.0 - shiftN));
    this.right.load(Math.max(MIN_LOAD_N, axleN / 2.0 + shiftN));
  }

  private static DrivenWheel wheel(DifferentialParameters p, double x, double y, double loadN) {
    return new DrivenWheel(
        x, y, loadN, p.wheelRadiusM(), p.wheelInertiaKgM2(), p.motor(), p.tyre());
  }

  private static void requireLoad(String wheel, double newtons) {
    if (!(newtons > 0.0)) {
      throw new IllegalArgumentException(
          "payload: the " + wheel + " would carry " + newtons + " N: it lifts off");
    }
  }

  @Override
  void prepare(DriveCommand command) {
    left.command(limit(command.first() * (1.0 - mismatch)));
    right.command(limit(command.second() * (1.0 + mismatch)));
    double leftSpin = s[LEFT + DrivenWheel.SPIN];
    double rightSpin = s[RIGHT + DrivenWheel.SPIN];
    double volts =
        battery.volts(
            left.duty(),
            left.emfV(leftSpin),
            left.perOhm(),
            right.duty(),
            right.emfV(rightSpin),
            right.perOhm());
    left.supply(volts);
    right.supply(volts);
    battery.draw(left.drawnA(leftSpin) + right.drawnA(rightSpin), TICK_S);
    meetGround(left);
    meetGround(right);
    castor.ground(
        surface.rollingResistance(eastOf(castor.x(), castor.y()), northOf(castor.x(), castor.y())));
  }

  private void meetGround(DrivenWheel wheel) {
    double east = eastOf(wheel.x, wheel.y);
    double north = northOf(wheel.x, wheel.y);
    wheel.ground(surface.grip(east, north), surface.rollingResistance(east, north));
  }

  @Override
  void derive(double[] state, double[] rates) {
    rolling(left, LEFT, state, rates);
    rolling(right, RIGHT, state, rates);
    moment(left.scrubNm + right.scrubNm); // a single sum keeps mirrored runs exactly symmetric
    rates[CASTOR] = castor.derive(state[CASTOR], state[U], state[V], state[R]);
    force(castor.x(), castor.y(), castor.forceForward, castor.forceRight);
  }

  @Override
  void bound(FastestRate rate) {
    rate.add(left, s[LEFT + DrivenWheel.SPIN]);
    rate.add(right, s[RIGHT + DrivenWheel.SPIN]);
    rate.add(castor.settlingPerS(StrictMath.hypot(s[U], s[V])));
  }

  @Override
  void settle() {
    left.settle(s, LEFT, TICK_S);
    right.settle(s, RIGHT, TICK_S);
  }

  @Override
  boolean idle() {
    return left.idle() && right.idle();
  }

  @Override
  void halt() {
    left.halt(s, LEFT);
    right.halt(s, RIGHT);
  }

  @Override
  public List<String> actuators() {
    return List.of("LEFT MOTOR", "RIGHT MOTOR");
  }

  @Override
  public Footprint footprint() {
    return footprint;
  }

  @Override
  public GroundState state() {
    double leftSpin = s[LEFT + DrivenWheel.SPIN];
    double rightSpin = s[RIGHT + DrivenWheel.SPIN];
    return state(
        leftSpin,
        rightSpin,
        left.angleRad(),
        right.angleRad(),
        0.0,
        left.currentA(leftSpin),
        right.currentA(rightSpin));
  }

  private static double limit(double command) {
    return Math.max(-1.0, Math.min(1.0, command)); // NaN stays NaN
  }

  /**
   * A castor wheel. It rolls without side slip, so its angle follows from the pivot's motion; it
   * acts on the vehicle only through rolling resistance.
   */
  private static final class Castor {
    private final double x; // pivot position relative to the centre of gravity [m]
    private final double y;
    private final double trailM;
    private double loadN;
    private double dragN;

    // results of derive(), at the pivot, in vehicle axes
    double forceForward;
    double forceRight;

    Castor(double x, double y, double trailM, double loadN) {
      this.x = x;
      this.y = y;
      this.trailM = trailM;
      this.loadN = loadN;
    }

    /** Sets the wheel load [N], above 0. */
    void load(double newtons) {
      loadN = newtons;
    }

    void ground(double rolling) {
      dragN = rolling * loadN;
    }

    /** Rate at which it turns into its direction at a speed. */
    double settlingPerS(double speedMps) {
      return speedMps / trailM;
    }

    double x() {
      return x;
    }

    double y() {
      return y;
    }

    /**
     * @param angle of the wheel's rolling direction, clockwise from the vehicle's [rad]
     * @return its rate of change [rad/s]
     */
    double derive(double angle, double u, double v, double yawRate) {
      double forward = u - yawRate * y; // pivot velocity
      double right = v + yawRate * x;
      double sin = StrictMath.sin(angle);
      double cos = StrictMath.cos(angle);
      double drag = -dragN * PlanarVehicle.fading(forward * cos + right * sin);
      forceForward = drag * cos;
      forceRight = drag * sin;
      return (right * cos - forward * sin) / trailM - yawRate;
    }
  }
}
