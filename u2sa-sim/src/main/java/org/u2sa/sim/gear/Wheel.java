package org.u2sa.sim.gear;

import org.u2sa.sim.motion.BodyAttitude;

/**
 * A wheel or a skid on its leg: vertical spring and damper, and an elastic tyre that slides at its
 * friction limit. Places are in forward, right, down axes about the centre of gravity.
 *
 * <p>The tyre is the single contact point model (Pacejka, Tire and Vehicle Dynamics, chapter 7):
 * the contact patch is held back by springs. At rest it acts as an elastic anchor, so the aircraft
 * does not creep; when rolling, the deflection relaxes over a length, which makes the cornering
 * force proportional to the slip angle. Sliding limits: friction ellipse.
 */
public final class Wheel {
  /** Maximum leg travel [m]; beyond it the structure hits the runway. */
  public static final double DEEPEST_M = 0.30;

  private static final double DAMPED_BELOW_MPS = 1.0;
  private static final double MIN_SIDE = 0.2; // fraction of lateral grip kept by a locked wheel

  private final double x;
  private final double y;
  private final double z;
  private final double stiffness;
  private final double legDamping;
  private final Tyre tyre;
  private final double steerRad; // at full rudder, right positive
  private double cosSteer = 1.0;
  private double sinSteer;
  private double brake;

  // results of compute(), NED
  private double forceN;
  private double forceE;
  private double forceD;
  private double slipAlongMps;
  private double slipAcrossMps;
  private double along;
  private double across;
  private double alongLimit;
  private double acrossLimit;
  private double compression;
  private double sinkMps;

  /**
   * @param x ahead of the centre of gravity [m]
   * @param y right of it [m]
   * @param z below it with the leg unloaded [m]
   * @param stiffness of the leg [N/m]
   * @param damping of the leg [N s/m]
   * @param steerRad steering angle at full rudder, right positive [rad]
   */
  public Wheel(
      double x, double y, double z, double stiffness, double damping, Tyre tyre, double steerRad) {
    this.x = x;
    this.y = y;
    this.z = z;
    this.stiffness = stiffness;
    this.legDamping = damping;
    this.tyre = tyre;
    this.steerRad = steerRad;
  }

  /**
   * Steers and brakes.
   *
   * @param rudder −1…1, right positive
   * @param newBrake 0…1
   */
  public void set(double rudder, double newBrake) {
    cosSteer = StrictMath.cos(steerRad * rudder);
    sinSteer = StrictMath.sin(steerRad * rudder);
    brake = newBrake;
  }

  /**
   * Computes the forces of the ground.
   *
   * @param heightM height of the unloaded contact point above ground, negative when compressed
   * @param velN velocity of that point, north [m/s]
   * @param velE velocity east [m/s]
   * @param velD velocity down [m/s]
   * @param deflectionAlong longitudinal tyre deflection [m]
   * @param deflectionAcross lateral tyre deflection [m]
   */
  public void compute(
      BodyAttitude attitude,
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
    double rollN = attitude.north(cosSteer, sinSteer, 0.0);
    double rollE = attitude.east(cosSteer, sinSteer, 0.0);
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
    alongLimit = (tyre.rolling() + tyre.brakeGrip() * brake) * load;
    along = limit(-tyre.stiffness() * deflectionAlong - tyre.damping() * slipAlongMps, alongLimit);
    double grip = tyre.grip() * load;
    acrossLimit =
        StrictMath.sqrt(Math.max(MIN_SIDE * MIN_SIDE * grip * grip, grip * grip - along * along));
    // While rolling, fresh tread enters the contact patch and damped tread leaves it.
    double damping = tyre.damping() / (1.0 + Math.abs(slipAlongMps) / DAMPED_BELOW_MPS);
    across = limit(-tyre.stiffness() * deflectionAcross - damping * slipAcrossMps, acrossLimit);
    forceN = along * rollN - across * rollE;
    forceE = along * rollE + across * rollN;
    forceD = -load;
  }

  /** Rate of the longitudinal tyre deflection [m/s]. */
  public double deflectionAlongRate() {
    return slipAlongMps;
  }

  /** Rate of the lateral tyre deflection [m/s]. */
  public double deflectionAcrossRate(double deflection) {
    return slipAcrossMps - Math.abs(slipAlongMps) / tyre.relaxationM() * deflection;
  }

  /** Limits the longitudinal tyre deflection to what friction can hold [m]. */
  public double boundedAlong(double deflection) {
    return limit(deflection, alongLimit / tyre.stiffness());
  }

  /** The same, lateral. */
  public double boundedAcross(double deflection) {
    return limit(deflection, acrossLimit / tyre.stiffness());
  }

  /** Compression of the leg; 0 in the air [m]. */
  public double compressionM() {
    return compression;
  }

  /** Sink rate of the contact point [m/s]. */
  public double sinkMps() {
    return sinkMps;
  }

  /** Ahead of the centre of gravity [m]. */
  public double x() {
    return x;
  }

  /** Right of the centre of gravity [m]. */
  public double y() {
    return y;
  }

  /** Below the centre of gravity, with the leg unloaded [m]. */
  public double z() {
    return z;
  }

  /** Force of the ground, north [N]. */
  public double forceN() {
    return forceN;
  }

  /** Force of the ground, east [N]. */
  public double forceE() {
    return forceE;
  }

  /** Force of the ground, down; negative [N]. */
  public double forceD() {
    return forceD;
  }

  private static double limit(double value, double bound) {
    return Math.max(-bound, Math.min(bound, value));
  }
}
