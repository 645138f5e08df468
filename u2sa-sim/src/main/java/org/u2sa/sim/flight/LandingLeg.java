package org.u2sa.sim.flight;

import java.util.List;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.gear.Tyre;
import org.u2sa.sim.gear.Wheel;

/**
 * Landing-gear leg of an aircraft: a skid, or an unbraked wheel.
 *
 * @param place lowest point, unloaded, relative to the centre of gravity: forward, right, down [m]
 * @param rolls whether it is a wheel
 * @param steering angle of the wheel per angle of the rudder to which it is linked; 0: rolls
 *     straight ahead
 */
public record LandingLeg(Point place, boolean rolls, double steering) {
  private static final double COMPRESSION_M = 0.01; // under the aircraft's weight
  private static final double DAMPING_RATIO = 0.7;
  private static final double GRIP = 0.6; // rubber or plastic on grass
  private static final double ROLLING = 0.05; // small wheels on short grass
  private static final double RELAXATION_M = 0.1;

  /** Compression that breaks a leg: a drop at about 3 m/s [m]. */
  static final double BREAKS_AT_M = 0.1;

  /** A skid, or a wheel that rolls straight ahead. */
  public static LandingLeg straight(Point place, boolean rolls) {
    return new LandingLeg(place, rolls, 0.0);
  }

  /**
   * Springs that carry an aircraft of this mass together.
   *
   * @throws IllegalArgumentException if there are one or two legs
   */
  static List<Wheel> wheels(List<LandingLeg> legs, double massKg) {
    if (!legs.isEmpty() && legs.size() < 3) {
      throw new IllegalArgumentException("legs: " + legs.size() + "; expected none, or at least 3");
    }
    return legs.stream().map(leg -> leg.wheel(massKg / legs.size())).toList();
  }

  private Wheel wheel(double carriedKg) {
    double stiffness = carriedKg * Gravity.STANDARD_MPS2 / COMPRESSION_M;
    double damping = 2.0 * DAMPING_RATIO * StrictMath.sqrt(stiffness * carriedKg);
    Tyre tyre = new Tyre(stiffness, damping, GRIP, rolls ? ROLLING : GRIP, 0.0, RELAXATION_M);
    return new Wheel(place.x(), place.y(), place.z(), stiffness, damping, tyre, steering);
  }
}
