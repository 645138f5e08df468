package org.u2sa.sim.aircraft;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.gear.Tyre;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.BodyAttitude;

/**
 * Tricycle gear of the Cessna 172: nose wheel steered by the pedals (10° each way: Pilot's
 * Operating Handbook, section 7), two braked main wheels, and the airframe points that must not
 * touch the ground. Wheel base 65 in, track 99.5 in (handbook, section 1); springs chosen for a
 * static compression of 6–10 cm and a level stance.
 */
final class LandingGear {
  /** Height of the centre of gravity above ground when parked [m]. */
  static final double STANDING_M = 1.25;

  /** Pitch of the body axes when parked; these axes are aligned with the flow in cruise. */
  static final double STANDING_PITCH_RAD = Math.toRadians(2.5);

  static final int WHEELS = 3;
  private static final double NOSE_X = 1.214;
  private static final double MAIN_X = -0.437;
  private static final double HALF_TRACK = 1.264;
  private static final double WEIGHT_N = Airframe.MASS_KG * Gravity.STANDARD_MPS2;
  private static final double NOSE_SHARE = -MAIN_X / (NOSE_X - MAIN_X);
  private static final double NOSE_STIFFNESS = 30_000.0;
  private static final double MAIN_STIFFNESS = 70_000.0;
  private static final double STEER_RAD = Math.toRadians(10.0);

  // Cornering stiffness is roughly proportional to static load, so an aircraft with equal tyres
  // steers neutrally (Pacejka, Tire and Vehicle Dynamics, chapter 1); these are sums over all
  // wheels.
  private static final double TYRE_STIFFNESS_OF_ALL = 270_000.0; // longitudinal and lateral [N/m]
  private static final double TYRE_DAMPING_OF_ALL = 12_000.0; // [N s/m]
  private static final double RELAXATION_M = 0.3; // half to one wheel radius
  private static final double GRIP = 0.7; // dry asphalt, light aircraft tyre
  private static final double BRAKE_GRIP = 0.45; // share the 172's single-disc brakes can use
  private static final double ROLLING = 0.02; // hard runway: McCormick, table 7.2

  /**
   * Maximum sink rate the gear withstands: 10 ft/s (14 CFR 23.473) plus 20 % reserve (23.723)
   * [m/s].
   */
  private static final double HARDEST_SINK_MPS = 3.66;

  private static final double MIN_FALL_MPS = 0.3; // a lower sink rate is rolling, not a touchdown

  /**
   * Wing tips, propeller tip, tie-down ring under the tail, fin and cabin roof: x, y, z [m] in body
   * axes from the centre of gravity.
   */
  private static final double[][] CORNERS = {
    {0.0, -5.48, -0.75},
    {0.0, 5.48, -0.75},
    {1.75, 0.0, 0.95},
    {-4.85, 0.0, 0.15},
    {-5.3, 0.0, -1.45},
    {0.0, 0.0, -1.0},
  };

  final Wheel[] wheels = {
    wheel(NOSE_X, 0.0, NOSE_SHARE, NOSE_STIFFNESS, 3_500.0, STEER_RAD),
    wheel(MAIN_X, -HALF_TRACK, (1.0 - NOSE_SHARE) / 2.0, MAIN_STIFFNESS, 5_000.0, 0.0),
    wheel(MAIN_X, HALF_TRACK, (1.0 - NOSE_SHARE) / 2.0, MAIN_STIFFNESS, 5_000.0, 0.0)
  };

  private final boolean[] touching = new boolean[WHEELS];

  /**
   * Creates a wheel positioned so that the parked aircraft has its height and pitch with this
   * fraction of the weight on the wheel.
   */
  private static Wheel wheel(
      double x, double y, double share, double stiffness, double damping, double steerRad) {
    double reach = STANDING_M + share * WEIGHT_N / stiffness;
    double z =
        (reach + x * StrictMath.sin(STANDING_PITCH_RAD)) / StrictMath.cos(STANDING_PITCH_RAD);
    Tyre tyre =
        new Tyre(
            TYRE_STIFFNESS_OF_ALL * share,
            TYRE_DAMPING_OF_ALL * share,
            GRIP,
            ROLLING,
            BRAKE_GRIP,
            RELAXATION_M);
    return new Wheel(x, y, z, stiffness, damping, tyre, steerRad);
  }

  void set(ControlInputs inputs) {
    wheels[0].set(inputs.rudder(), 0.0);
    wheels[1].set(0.0, inputs.brakeLeft());
    wheels[2].set(0.0, inputs.brakeRight());
  }

  boolean weightOnWheels() {
    return wheels[1].compressionM() > 0.0 || wheels[2].compressionM() > 0.0;
  }

  /** Whether the aircraft crashed in this step; call once per step, after computing the wheels. */
  boolean broken(BodyAttitude attitude, double heightM) {
    boolean broken = false;
    for (int i = 0; i < WHEELS; i++) {
      boolean down = wheels[i].compressionM() > 0.0;
      boolean hard = !touching[i] && down && wheels[i].sinkMps() > HARDEST_SINK_MPS;
      broken |= hard || wheels[i].compressionM() > Wheel.DEEPEST_M;
      touching[i] = down && (touching[i] || wheels[i].sinkMps() > -MIN_FALL_MPS);
    }
    for (double[] corner : CORNERS) {
      broken |= heightM < attitude.down(corner[0], corner[1], corner[2]);
    }
    return broken;
  }
}
