package org.u2sa.flightgear.control;

/** The gains of config/cessna/Control.xml, for flights without services. */
final class TestTuning {
  private static final double KNOT = 1852.0 / 3600.0;

  private TestTuning() {}

  static Tuning standard() {
    return new Tuning(
        46.0,
        43.0,
        60.0,
        Math.toRadians(26.0),
        Math.toRadians(15.0),
        0.12,
        Math.toRadians(-10.0),
        Math.toRadians(14.0),
        150.0,
        new RollLaw.Parameters(0.8, Math.toRadians(20.0), new RateLoop.Gains(0.9, 0.15, 0.2, 0.4)),
        new PitchLaw.Parameters(
            0.7, Math.toRadians(10.0), new RateLoop.Gains(0.5, 0.25, 0.8, 0.6)),
        new YawLaw.Parameters(0.5, 0.8, 0.4, 0.5, 0.45),
        new StallGuard.Parameters(26.2, 1.2, 4.0, Math.toRadians(12.0)),
        new EnergyParameters(
            5.0, 6.0, 3.5, 4.0, 0.8, 1.0, 2.0, 0.6, 4.0, 1.5, 1.0, 0.0, 1.0, 0.3, 0.037, 0.6, 0.3,
            Math.toRadians(3.0), 20.0),
        new TakeOffSequence.Parameters(600.0, 1.0, 0.5, 55.0 * KNOT, 100.0),
        new GroundSteering.Parameters(2.0, 40.0, 1.2, 9.5, 0.3, 0.3, 1.5, 1.5, 1.2, 0.1),
        new Tuning.ClimbOut(
            0.2, 0.3, Math.toRadians(10.0), Math.toRadians(5.0), 74.0 * KNOT, Math.toRadians(6.0),
            Math.toRadians(10.0), 250.0));
  }
}
