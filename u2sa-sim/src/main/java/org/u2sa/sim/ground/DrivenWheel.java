package org.u2sa.sim.ground;

/**
 * A driven wheel: brushed motor, gear friction, and a tyre with creep and slip.
 *
 * <p>Four states: spin [rad/s], longitudinal and lateral tyre deflection [m], and dry-friction
 * preload, −1…1 (Dahl 1968: friction as a yielding spring, so a wheel stays still until its motor
 * overcomes it). The last is updated by {@link #settle}, the others by the integrator.
 */
final class DrivenWheel {
  static final int SPIN = 0;
  static final int ALONG = 1;
  static final int ACROSS = 2;
  static final int SIZE = 3;

  private static final double WIND_UP_M = 0.002; // travel at the rim to full friction
  private static final double FRICTION_DAMPING_S = 0.05; // damping of the friction spring
  private static final double SCRUB_MPS = 0.05; // slip at the patch edge that saturates scrub
  private static final double DISC = 2.0 / 3.0; // uniform pressure on a disc: M = 2/3 µ N a

  /** Position relative to the centre of gravity [m]. */
  final double x;

  final double y;
  private double loadN;
  private final double radiusM;
  private final double inertia;
  private final MotorParameters motor;
  private final double constant;
  private final double loss;
  private final double drag;
  private final TyreParameters tyre;
  private double stiffness;

  // held during a tick
  private boolean powered;
  private double dutyV;
  private double duty;
  private double gripN;
  private double rollingNm;
  private double wound;

  // results of derive(), in vehicle axes
  double forceAlong;
  double forceAcross;
  double scrubNm;
  private double angle;
  private double lastSpin;

  /**
   * @param x ahead of the centre of gravity [m]
   * @param y right of it [m]
   * @param wheelInertia inertia without motor [kg m²]
   */
  DrivenWheel(
      double x,
      double y,
      double loadN,
      double radiusM,
      double wheelInertia,
      MotorParameters motor,
      TyreParameters tyre) {
    this.x = x;
    this.y = y;
    this.radiusM = radiusM;
    this.motor = motor;
    this.tyre = tyre;
    this.inertia = wheelInertia + motor.inertiaKgM2();
    this.constant = motor.constant();
    this.loss = 1.0 - motor.efficiency();
    this.drag = motor.dragNm();
    load(loadN);
  }

  /** Sets the wheel load [N], above 0. */
  void load(double newtons) {
    loadN = newtons;
    stiffness = tyre.slipStiffness() * loadN / tyre.relaxationM();
  }

  /** Sets the inputs held during a tick. NaN: no pulses, motor off. */
  void command(double command) {
    powered = !Double.isNaN(command);
    duty = powered ? motor.duty(command) : 0.0;
  }

  void supply(double volts) {
    dutyV = duty * volts;
  }

  void ground(double grip, double rolling) {
    gripN = grip * loadN;
    rollingNm = rolling * loadN * radiusM;
  }

  double duty() {
    return duty;
  }

  double emfV(double spin) {
    return constant * spin;
  }

  double perOhm() {
    return powered ? 1.0 / motor.resistanceOhm() : 0.0;
  }

  double currentA(double spin) {
    return powered ? (dutyV - constant * spin) / motor.resistanceOhm() : 0.0;
  }

  /** Bound of the rate at which spin and tyre settle in a tick that begins at a spin [1/s]. */
  double settlingPerS(double spin) {
    double ohm = motor.resistanceOhm();
    double torque = constant * (Math.abs(dutyV) + Math.abs(constant * spin)) / ohm;
    double friction = FRICTION_DAMPING_S * radiusM / WIND_UP_M * holdNm(torque);
    double motorNms = powered ? constant * constant / ohm : 0.0;
    double fastest = Math.max(Math.abs(spin), Math.abs(dutyV) / constant);
    return (damperNsPerM() * radiusM * radiusM + motorNms + friction) / inertia
        + fastest * radiusM / tyre.relaxationM();
  }

  /** Square of the rate at which the wheel oscillates on its tyre [1/s²]. */
  double squaredPerS2() {
    return stiffness * radiusM * radiusM / inertia;
  }

  double springNPerM() {
    return stiffness;
  }

  double damperNsPerM() {
    return stiffness * tyre.dampingS();
  }

  /** Damping of yaw by the patch at rest [N m s]. */
  double scrubNms() {
    return DISC * gripN * tyre.patchRadiusM() * tyre.patchRadiusM() / SCRUB_MPS;
  }

  /** Battery current of the motor [A]. */
  double drawnA(double spin) {
    return duty * currentA(spin);
  }

  /** Whether the motor only brakes or coasts. */
  boolean idle() {
    return duty == 0.0;
  }

  /**
   * @param at index of this wheel's first state
   * @param alongMps velocity of the wheel's hub over ground, along the wheel
   * @param acrossMps lateral velocity, right positive
   * @param yawRate yaw rate of the wheel [rad/s]
   */
  void derive(
      double[] s, int at, double alongMps, double acrossMps, double yawRate, double[] rate) {
    double spin = s[at + SPIN];
    double fresh =
        Math.abs(spin)
            * radiusM
            / tyre.relaxationM(); // rate of fresh tread entering the patch [1/s]
    double stretch = alongMps - spin * radiusM - fresh * s[at + ALONG];
    double drift = acrossMps - fresh * s[at + ACROSS];
    double along = -stiffness * (s[at + ALONG] + tyre.dampingS() * stretch);
    double across = -stiffness * (s[at + ACROSS] + tyre.dampingS() * drift);
    double size = StrictMath.sqrt(along * along + across * across);
    double share = size > gripN ? gripN / size : 1.0; // friction circle
    forceAlong = share * along;
    forceAcross = share * across;
    double edge = yawRate * tyre.patchRadiusM();
    scrubNm =
        -DISC
            * gripN
            * tyre.patchRadiusM()
            * edge
            / StrictMath.sqrt(edge * edge + alongMps * alongMps + SCRUB_MPS * SCRUB_MPS);
    double torque = constant * currentA(spin);
    double friction = limit(wound + FRICTION_DAMPING_S * winding(spin)) * holdNm(torque);
    rate[at + SPIN] = (torque - friction - forceAlong * radiusM) / inertia;
    rate[at + ALONG] = stretch;
    rate[at + ACROSS] = drift;
  }

  /**
   * Called after a tick: updates friction preload, limits tyre deflection to grip, counts rotation.
   */
  void settle(double[] s, int at, double dtS) {
    double spin = s[at + SPIN];
    double turned = spin * radiusM * dtS / WIND_UP_M;
    wound = (wound + turned) / (1.0 + Math.abs(turned)); // backward Euler of winding()
    double longest = gripN / stiffness;
    double length =
        StrictMath.sqrt(s[at + ALONG] * s[at + ALONG] + s[at + ACROSS] * s[at + ACROSS]);
    if (length > longest) {
      s[at + ALONG] *= longest / length;
      s[at + ACROSS] *= longest / length;
    }
    angle += 0.5 * (lastSpin + spin) * dtS;
    lastSpin = spin;
  }

  /** Resets the wheel to rest. */
  void halt(double[] s, int at) {
    s[at + SPIN] = 0.0;
    s[at + ALONG] = 0.0;
    s[at + ACROSS] = 0.0;
    wound = 0.0;
    lastSpin = 0.0;
  }

  double angleRad() {
    return angle;
  }

  private double winding(double spin) {
    return spin * radiusM / WIND_UP_M * (1.0 - wound * Math.signum(spin));
  }

  private double holdNm(double torque) {
    return drag + rollingNm + loss * Math.abs(torque);
  }

  private static double limit(double value) {
    return Math.max(-1.0, Math.min(1.0, value));
  }
}
