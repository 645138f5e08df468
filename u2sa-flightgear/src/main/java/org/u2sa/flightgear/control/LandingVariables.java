package org.u2sa.flightgear.control;

import static org.u2sa.flightgear.control.BoundedNumber.number;

import org.u2sa.interfaces.Configurator;
import org.u2sa.interfaces.Variable;

/**
 * How the aircraft circles where navigation is lost, and touches down where it leads to the ground.
 */
final class LandingVariables {
  static final Variable<Double> HOLD_LEVEL_TIME =
      number(
          "HOLD LEVEL TIME",
          "s",
          0.0,
          60.0,
          5.0,
          "How long the wings stay level without navigation before it circles.");
  static final Variable<Double> HOLD_BANK =
      number(
          "HOLD BANK",
          "deg",
          0.0,
          30.0,
          15.0,
          "Bank to the right of the circle flown without navigation; 0 flies straight on.");
  static final Variable<Double> FLARE_HEIGHT =
      number(
          "FLARE HEIGHT",
          "m",
          1.0,
          30.0,
          9.0,
          "Height above ground at which sink and power are taken away, if navigation leads to the ground.");
  static final Variable<Double> FLARE_TIME =
      number(
          "FLARE TIME CONSTANT",
          "s",
          0.5,
          10.0,
          4.0,
          "The sink demanded in the flare is the height over this time.");
  static final Variable<Double> FLARE_SINK =
      number("FLARE SINK", "m/s", 0.1, 2.0, 0.5, "Sink at which the wheels are to touch.");
  static final Variable<Double> FLARE_GAIN =
      number("FLARE GAIN", "rad/m", 0.001, 1.0, 0.08, "Pitch rate per difference of sink.");
  static final Variable<Double> FLARE_PITCH_LIMIT =
      number("FLARE PITCH LIMIT", "deg", 2.0, 14.0, 10.0, "Most pitch demanded in the flare.");

  private LandingVariables() {}

  static Tuning.Hold hold(Configurator c) {
    return new Tuning.Hold(
        c.getVariable(HOLD_LEVEL_TIME), Math.toRadians(c.getVariable(HOLD_BANK)));
  }

  static FlareLaw.Parameters flare(Configurator c) {
    return new FlareLaw.Parameters(
        c.getVariable(FLARE_HEIGHT),
        c.getVariable(FLARE_TIME),
        c.getVariable(FLARE_SINK),
        c.getVariable(FLARE_GAIN),
        Math.toRadians(c.getVariable(FLARE_PITCH_LIMIT)));
  }
}
