package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * A vehicle with two driven wheels and a castor in front.
 *
 * @param massKg without payload [kg]
 * @param yawInertiaKgM2 without payload, about its own centre of gravity [kg m²]
 * @param cogAheadM of the driven axle, without payload [m]
 * @param cogHeightM height of the centre of gravity, with and without payload [m]
 * @param trackM between the driven wheels' middles [m]
 * @param castorAheadM the castor's pivot, ahead of the driven axle [m]
 * @param castorTrailM by which the castor's wheel is behind its pivot [m]
 * @param wheelRadiusM of the driven wheels [m]
 * @param wheelInertiaKgM2 of one driven wheel without its motor [kg m²]
 * @param mismatch by which the right motor is stronger and the left weaker than nominal, −0.5…0.5
 */
public record DifferentialParameters(
    double massKg,
    double yawInertiaKgM2,
    double cogAheadM,
    double cogHeightM,
    double trackM,
    double castorAheadM,
    double castorTrailM,
    double wheelRadiusM,
    double wheelInertiaKgM2,
    double mismatch,
    MotorParameters motor,
    TyreParameters tyre,
    BatteryParameters battery,
    Payload payload) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public DifferentialParameters {
    Arguments.requirePositive("mass", massKg);
    Arguments.requirePositive("yaw inertia", yawInertiaKgM2);
    Arguments.requireInside("height of the centre of gravity", cogHeightM, 0.0, 2.0);
    Arguments.requirePositive("track", trackM);
    Arguments.requirePositive("castor ahead", castorAheadM);
    Arguments.requirePositive("castor trail", castorTrailM);
    Arguments.requirePositive("wheel radius", wheelRadiusM);
    Arguments.requirePositive("wheel inertia", wheelInertiaKgM2);
    Arguments.requireInside("centre of gravity ahead", cogAheadM, 0.0, castorAheadM);
    Arguments.requireInside("mismatch", mismatch, -0.5, 0.5);
  }

  /**
   * The Mini-Molle of thesis 4.6.3. The thesis gives its layout and no dimensions: mass, sizes and
   * motors here are those of a vehicle of its kind, 0.6 m by 0.45 m and 20 kg with 8 inch wheels,
   * fast for walking pace (1.9 m/s on grass). Its inertia is that of an even plate, m (a² + b²) /
   * 12; each wheel weighs 0.8 kg, m r² 5 / 8 between disc and ring.
   */
  public static DifferentialParameters miniMolle() {
    return new DifferentialParameters(
        20.0,
        0.94,
        0.08,
        0.20,
        0.44,
        0.42,
        0.04,
        0.10,
        0.005,
        0.0,
        MotorParameters.pg27(),
        TyreParameters.wheelbarrow(),
        BatteryParameters.leadAcid7Ah(),
        Payload.none());
  }

  /** The same with another payload. */
  public DifferentialParameters withPayload(Payload newPayload) {
    return with(mismatch, battery, newPayload);
  }

  /** The same with motors that differ. */
  public DifferentialParameters withMismatch(double newMismatch) {
    return with(newMismatch, battery, payload);
  }

  /** The same with another battery. */
  public DifferentialParameters withBattery(BatteryParameters newBattery) {
    return with(mismatch, newBattery, payload);
  }

  private DifferentialParameters with(
      double newMismatch, BatteryParameters newBattery, Payload newPayload) {
    return new DifferentialParameters(
        massKg,
        yawInertiaKgM2,
        cogAheadM,
        cogHeightM,
        trackM,
        castorAheadM,
        castorTrailM,
        wheelRadiusM,
        wheelInertiaKgM2,
        newMismatch,
        motor,
        tyre,
        newBattery,
        newPayload);
  }
}
