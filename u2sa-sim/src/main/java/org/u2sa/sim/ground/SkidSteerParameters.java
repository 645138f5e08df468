package org.u2sa.sim.ground;

import java.util.List;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.world.Footprint;

/**
 * Parameters of a vehicle with driven, unsteered wheels in pairs, one motor per wheel. All motors
 * on one side receive the same command. Lengths are relative to the reference point on the ground.
 *
 * @param massKg mass [kg]
 * @param yawInertiaKgM2 about the centre of gravity [kg m²]
 * @param cogAheadM centre of gravity ahead of the reference point [m]
 * @param cogHeightM height of the centre of gravity [m]
 * @param axlesM positions of the pairs of wheels ahead of the reference point [m]; at least two
 * @param trackM distance between the wheels of a pair [m]
 * @param wheelRadiusM [m]
 * @param wheelInertiaKgM2 inertia of one wheel without motor [kg m²]
 * @param mismatch motors of the right side stronger and of the left side weaker than nominal by
 *     this share, −0.5…0.5
 * @param motor each wheel's
 * @param footprint collision outline
 */
public record SkidSteerParameters(
    double massKg,
    double yawInertiaKgM2,
    double cogAheadM,
    double cogHeightM,
    List<Double> axlesM,
    double trackM,
    double wheelRadiusM,
    double wheelInertiaKgM2,
    double mismatch,
    MotorParameters motor,
    TyreParameters tyre,
    BatteryParameters battery,
    Footprint footprint) {
  /**
   * @throws IllegalArgumentException if a value is outside its range, or all axles are at the same
   *     position
   */
  public SkidSteerParameters {
    Arguments.requirePositive("mass", massKg);
    Arguments.requirePositive("yaw inertia", yawInertiaKgM2);
    Arguments.requireFinite("centre of gravity ahead", cogAheadM);
    Arguments.requireInside("height of the centre of gravity", cogHeightM, 0.0, 2.0);
    Arguments.requirePositive("track", trackM);
    Arguments.requirePositive("wheel radius", wheelRadiusM);
    Arguments.requirePositive("wheel inertia", wheelInertiaKgM2);
    Arguments.requireInside("mismatch", mismatch, -0.5, 0.5);
    axlesM = List.copyOf(axlesM);
    if (axlesM.stream().distinct().count() < 2) {
      throw new IllegalArgumentException(
          "axles " + axlesM + ": expected at least two different positions");
    }
  }
}
