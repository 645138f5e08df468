package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/**
 * Parameters of a vehicle with two driven wheels and a front castor.
 *
 * @param massKg mass without payload [kg]
 * @param yawInertiaKgM2 without payload, about its own centre of gravity [kg m²]
 * @param cogAheadM centre of gravity ahead of the driven axle, without payload [m]
 * @param cogHeightM height of the centre of gravity, with and without payload [m]
 * @param trackM track width between the driven wheels [m]
 * @param castorAheadM castor pivot ahead of the driven axle [m]
 * @param castorTrailM castor trail [m]
 * @param wheelRadiusM radius of the driven wheels [m]
 * @param wheelInertiaKgM2 inertia of one driven wheel without motor [kg m²]
 * @param mismatch motor mismatch: right motor stronger and left weaker than nominal by this share,
 *     −0.5…0.5
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
   * The Mini-Molle of thesis 4.6.3. The thesis gives the layout but no dimensions; mass, sizes and
   * motors here are typical of such a vehicle: 0.6 m by 0.45 m, 20 kg, 8 inch wheels, a brisk
   * walking pace (1.9 m/s on grass). Yaw inertia of a uniform plate, m (a² + b²) / 12; each wheel
   * weighs 0.8 kg, inertia 5/8 m r², between disc and ring.
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

  /** Copy with a different payload. */
  public DifferentialParameters withPayload(Payload newPayload) {
    return with(mismatch, battery, newPayload);
  }

  /** Copy with a different motor mismatch. */
  public DifferentialParameters withMismatch(double newMismatch) {
    return with(newMismatch, battery, payload);
  }

  /** Copy with a different battery. */
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
