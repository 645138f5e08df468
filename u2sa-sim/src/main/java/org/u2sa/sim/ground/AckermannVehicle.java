package org.u2sa.sim.ground;

import java.util.List;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.world.Footprint;

/**
 * Single-track model of a vehicle with front steering and rear drive: a kinematic bicycle at
 * walking pace, with tyre slip angles at higher speed (Rajamani, Vehicle Dynamics and Control,
 * chapter 2, forces limited by grip). Commands: throttle, steering. Slopes transfer weight between
 * the axles; acceleration does not.
 */
public final class AckermannVehicle extends PlanarVehicle {
  private static final int REAR = FREE;
  private static final int FRONT = REAR + DrivenWheel.SIZE; // lateral tyre deflection [m]
  private static final int STEER = FRONT + 1; // [rad]
  private static final int SIZE = STEER + 1;
  private final AckermannParameters p;
  private final Chassis chassis;
  private final DrivenWheel rear;
  private final SteeredWheel front;
  private final Footprint footprint;
  private double steerTarget = Double.NaN; // NaN: servo unpowered

  /**
   * Like the other constructor, with a different collision outline.
   *
   * @throws IllegalArgumentException if the payload lifts an axle
   */
  public AckermannVehicle(AckermannParameters p, GroundStart start, Footprint footprint) {
    this(
        p,
        start,
        footprint,
        Chassis.of(p.massKg(), p.yawInertiaKgM2(), p.cogAheadM(), p.payload()));
  }

  private AckermannVehicle(
      AckermannParameters p, GroundStart start, Footprint footprint, Chassis chassis) {
    super(start, SIZE, chassis.centred(), new Battery(p.battery()));
    this.p = p;
    this.footprint = footprint;
    this.chassis = chassis;
    double weight = chassis.massKg() * Gravity.STANDARD_MPS2;
    double frontN = weight * chassis.cogAheadM() / p.wheelbaseM();
    if (!(frontN > 0.0 && frontN < weight)) {
      throw new IllegalArgumentException(
          "payload: the front axle would carry " + frontN + " of " + weight + " N: one lifts off");
    }
    double x = -chassis.cogAheadM();
    rear =
        new DrivenWheel(
            x, 0.0, weight - frontN, p.wheelRadiusM(), p.wheelInertiaKgM2(), p.motor(), p.tyre());
    front = new SteeredWheel(x + p.wheelbaseM(), frontN, p.tyre());
  }

  @Override
  void lean(double pressing, double forward, double right) {
    double weight = chassis.massKg() * Gravity.STANDARD_MPS2;
    double ahead = pressing * chassis.cogAheadM() + forward * p.cogHeightM();
    double frontN = weight * ahead / p.wheelbaseM();
    rear.load(Math.max(MIN_LOAD_N, weight * pressing - frontN));
    front.load(Math.max(MIN_LOAD_N, frontN));
  }

  @Override
  void prepare(DriveCommand command) {
    rear.command(command.first());
    steerTarget = command.second() * p.steerMaxRad();
    double spin = s[REAR + DrivenWheel.SPIN];
    rear.supply(battery.volts(rear.duty(), rear.emfV(spin), rear.perOhm(), 0.0, 0.0, 0.0));
    battery.draw(rear.drawnA(spin), TICK_S);
    double east = eastOf(rear.x, 0.0);
    double north = northOf(rear.x, 0.0);
    rear.ground(surface.grip(east, north), surface.rollingResistance(east, north));
    east = eastOf(front.x, 0.0);
    north = northOf(front.x, 0.0);
    front.ground(surface.grip(east, north), surface.rollingResistance(east, north));
  }

  @Override
  void derive(double[] state, double[] rates) {
    double across = state[V] + state[R] * rear.x;
    rear.derive(state, REAR, state[U], across, state[R], rates);
    force(rear.x, 0.0, rear.forceAlong, rear.forceAcross);
    moment(rear.scrubNm);
    double ahead = state[V] + state[R] * front.x;
    rates[FRONT] = front.derive(state[FRONT], state[STEER], state[U], ahead);
    force(front.x, 0.0, front.forceForward, front.forceRight);
    rates[STEER] = steerRate(state[STEER]);
  }

  private double steerRate(double steer) {
    if (Double.isNaN(steerTarget)) {
      return 0.0;
    }
    double wanted = (steerTarget - steer) / p.steerLagS();
    return Math.max(-p.steerRateRadPerS(), Math.min(p.steerRateRadPerS(), wanted));
  }

  @Override
  void bound(FastestRate rate) {
    rate.add(rear, s[REAR + DrivenWheel.SPIN]);
    rate.add(front.x, 0.0, front.stiffness, front.damperNsPerM());
    rate.add(1.0 / p.steerLagS());
  }

  @Override
  void settle() {
    rear.settle(s, REAR, TICK_S);
    s[FRONT] = front.bounded(s[FRONT]);
  }

  @Override
  boolean idle() {
    return rear.idle() && Math.abs(steerRate(s[STEER])) < 1e-6;
  }

  @Override
  void halt() {
    rear.halt(s, REAR);
    s[FRONT] = 0.0;
  }

  @Override
  public List<String> actuators() {
    return List.of("THROTTLE", "STEERING");
  }

  /** {@inheritDoc} Length 1.5 wheelbases, width 0.85 wheelbases, as typical cars. */
  @Override
  public Footprint footprint() {
    return footprint;
  }

  @Override
  public GroundState state() {
    double spin = s[REAR + DrivenWheel.SPIN];
    double angle = rear.angleRad();
    return state(spin, spin, angle, angle, s[STEER], rear.currentA(spin), 0.0);
  }

  /** A free-rolling steered front axle: no longitudinal force, lateral creep and slip. */
  private static final class SteeredWheel {
    /** Distance ahead of the centre of gravity [m]. */
    final double x;

    private double loadN;
    private final TyreParameters tyre;
    private double stiffness;
    private double gripN;
    private double dragN;

    // results of derive(), in vehicle axes
    double forceForward;
    double forceRight;

    SteeredWheel(double x, double loadN, TyreParameters tyre) {
      this.x = x;
      this.tyre = tyre;
      load(loadN);
    }

    /** Sets the axle load [N], above 0. */
    void load(double newtons) {
      loadN = newtons;
      stiffness = tyre.slipStiffness() * loadN / tyre.relaxationM();
    }

    double damperNsPerM() {
      return stiffness * tyre.dampingS();
    }

    void ground(double grip, double rolling) {
      gripN = grip * loadN;
      dragN = rolling * loadN;
    }

    /**
     * @param stretch lateral tyre deflection, right positive [m]
     * @param steer right positive [rad]
     * @param forward velocity of the axle [m/s]
     * @param right velocity of the axle [m/s]
     * @return rate of change of the deflection [m/s]
     */
    double derive(double stretch, double steer, double forward, double right) {
      double sin = StrictMath.sin(steer);
      double cos = StrictMath.cos(steer);
      double rolling = forward * cos + right * sin;
      double drift = right * cos - forward * sin - Math.abs(rolling) / tyre.relaxationM() * stretch;
      double across = -stiffness * (stretch + tyre.dampingS() * drift);
      across = Math.max(-gripN, Math.min(gripN, across));
      double along = -dragN * PlanarVehicle.fading(rolling);
      forceForward = along * cos - across * sin;
      forceRight = along * sin + across * cos;
      return drift;
    }

    double bounded(double stretch) {
      double longest = gripN / stiffness;
      return Math.max(-longest, Math.min(longest, stretch));
    }
  }
}
