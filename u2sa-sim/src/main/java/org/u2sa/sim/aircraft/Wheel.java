package org.u2sa.sim.aircraft;

/**
 * A wheel on its leg: vertical spring and damper, and an elastic tyre that slides at its friction
 * limit.
 *
 * <p>The tyre is the single contact point model (Pacejka, Tire and Vehicle Dynamics, chapter 7):
 * the contact patch is held back by springs. At rest it acts as an elastic anchor, so the aircraft
 * does not creep; when rolling, the deflection relaxes over a length, which makes the cornering
 * force proportional to the slip angle. Sliding limits: friction ellipse.
 */
final class Wheel {
  /** Maximum leg travel [m]; beyond it the structure hits the runway. */
  static final double DEEPEST_M = 0.30;

  // Cornering stiffness is roughly proportional to static load, so an aircraft with equal tyres
  // steers neutrally (Pacejka, chapter 1); these are sums over all wheels.
  private static final double TYRE_STIFFNESS_OF_ALL = 270_000.0; // longitudinal and lateral [N/m]
  private static final double TYRE_DAMPING_OF_ALL = 12_000.0; // [N s/m]
  private static final double DAMPED_BELOW_MPS = 1.0;
  private static final double RELAXATION_M = 0.3; // half to one wheel radius
  private static final double GRIP = 0.7; // dry asphalt, light aircraft tyre
  private static final double BRAKE_GRIP = 0.45; // share the 172's single-disc brakes can use
  private static final double ROLLING = 0.02; // hard runway: McCormick, table 7.2
  private static final double MIN_SIDE = 0.2; // share of lateral grip kept by a locked wheel

  final double x;
  final double y;
  final double z;
  private final double stiffness;
  private final double legDamping;
  private final double tyreStiffness;
  private final double tyreDamping;
  private final double steerRad; // at full rudder, right positive
  private double cosSteer = 1.0;
  private double sinSteer;
  private double brake;

  // results of compute(), NED
  double forceN;
  double forceE;
  double forceD;
  double slipAlongMps;
  double slipAcrossMps;
  private double along;
  private double across;
  private double alongLimit;
  private double acrossLimit;
  private double compression;
  private double sinkMps;

  /**
   * @param z distance below the centre of gravity with the leg unloaded [m]
   * @param stiffness [N/m]
   * @param damping [N s/m]
   * @param share share of the aircraft's weight it carries when parked, 0…1
   */
  Wheel(
      double x,
      double y,
      double z,
      double stiffness,
      double damping,
      double share,
      double steerRad) {
    this.x = x;
    this.y = y;
    this.z = z;
    this.stiffness = stiffness;
    this.legDamping = damping;
    this.tyreStiffness = TYRE_STIFFNESS_OF_ALL * share;
    this.tyreDamping = TYRE_DAMPING_OF_ALL * share;
    this.steerRad = steerRad;
  }

  void set(double rudder, double newBrake) {
    cosSteer = StrictMath.cos(steerRad * rudder);
    sinSteer = StrictMath.sin(steerRad * rudder);
    brake = newBrake;
  }

  /**
   * @param heightM height of the unloaded contact point above ground, negative when compressed
   * @param velN velocity of that point [m/s]
   * @param deflectionAlong longitudinal tyre deflection [m]
   */
  void compute(
      AircraftAttitude attitude,
      double heightM,
      double velN,
      double velE,
      double velD,
      double deflectionAlong,
      double deflectionAcross) {
    compression = Math.max(0.0, -heightM);
    sinkMps = velD;
    if (compression == 0.0) {
      forceN = forceE = forceD = slipAlongMps = slipAcrossMps = 0.0;
      alongLimit = acrossLimit = 0.0;
      return;
    }
    double load = Math.max(0.0, stiffness * compression + legDamping * velD);
    double rollN = attitude.xn * cosSteer + attitude.yn * sinSteer;
    double rollE = attitude.xe * cosSteer + attitude.ye * sinSteer;
    double length = StrictMath.sqrt(rollN * rollN + rollE * rollE);
    if (length > 1e-6) {
      rollN /= length;
      rollE /= length;
    } else {
      rollN = 1.0;
      rollE = 0.0;
    }
    slipAlongMps = velN * rollN + velE * rollE;
    slipAcrossMps = velE * rollN - velN * rollE;
    alongLimit = (ROLLING + BRAKE_GRIP * brake) * load;
    along = limit(-tyreStiffness * deflectionAlong - tyreDamping * slipAlongMps, alongLimit);
    double grip = GRIP * load;
    acrossLimit =
        StrictMath.sqrt(Math.max(MIN_SIDE * MIN_SIDE * grip * grip, grip * grip - along * along));
    // While rolling, fresh tread enters the contact patch and damped tread leaves it.
    double damping = tyreDamping / (1.0 + Math.abs(slipAlongMps) / DAMPED_BELOW_MPS);
    across = limit(-tyreStiffness * deflectionAcross - damping * slipAcrossMps, acrossLimit);
    forceN = along * rollN - across * rollE;
    forceE = along * rollE + across * rollN;
    forceD = -load;
  }

  double deflectionAlongRate() {
    return slipAlongMps;
  }

  double deflectionAcrossRate(double deflection) {
    return slipAcrossMps - Math.abs(slipAlongMps) / RELAXATION_M * deflection;
  }

  /** Limits tyre deflection to what friction can hold. */
  double boundedAlong(double deflection) {
    return limit(deflection, alongLimit / tyreStiffness);
  }

  double boundedAcross(double deflection) {
    return limit(deflection, acrossLimit / tyreStiffness);
  }

  double compressionM() {
    return compression;
  }

  /** Sink rate of the contact point [m/s]. */
  double sinkMps() {
    return sinkMps;
  }

  private static double limit(double value, double bound) {
    return Math.max(-bound, Math.min(bound, value));
  }
}
