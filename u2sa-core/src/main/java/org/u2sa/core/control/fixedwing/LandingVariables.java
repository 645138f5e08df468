package org.u2sa.core.control.fixedwing;

import static org.u2sa.core.control.fixedwing.BoundedNumber.number;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/**
 * How the aircraft circles where navigation is lost, and touches down where it leads to the ground.
 */
final class LandingVariables {
  static final VariableDeclaration<Double> HOLD_LEVEL_TIME =
      number(
          "HOLD LEVEL TIME",
          "s",
          0.0,
          60.0,
          5.0,
          "How long the wings stay level without navigation before it circles.");
  static final VariableDeclaration<Double> HOLD_BANK =
      number(
          "HOLD BANK",
          "deg",
          0.0,
          30.0,
          15.0,
          "Bank to the right of the circle flown without navigation; 0 flies straight on.");
  static final VariableDeclaration<Double> FLARE_HEIGHT =
      number(
          "FLARE HEIGHT",
          "m",
          1.0,
          30.0,
          9.0,
          "Height above ground at which sink and power are taken away, if navigation leads to the ground.");
  static final VariableDeclaration<Double> FLARE_TIME =
      number(
          "FLARE TIME CONSTANT",
          "s",
          0.5,
          10.0,
          4.0,
          "The sink demanded in the flare is the height over this time.");
  static final VariableDeclaration<Double> FLARE_SINK =
      number("FLARE SINK", "m/s", 0.1, 2.0, 0.5, "Sink at which the wheels are to touch.");
  static final VariableDeclaration<Double> FLARE_GAIN =
      number("FLARE GAIN", "rad/m", 0.001, 1.0, 0.03, "Pitch rate per difference of sink.");
  static final VariableDeclaration<Double> FLARE_DAMPING =
      number("FLARE DAMPING", "rad s/m", 0.0, 1.0, 0.04, "Pitch per difference of sink.");
  static final VariableDeclaration<Double> FLARE_PITCH_LIMIT =
      number("FLARE PITCH LIMIT", "deg", 2.0, 14.0, 10.0, "Most pitch demanded in the flare.");

  static final VariableDeclaration<Double> ALIGN_HEIGHT =
      number(
          "ALIGN HEIGHT",
          "m",
          0.0,
          10.0,
          1.5,
          "Height above ground at which the nose is turned along the runway.");
  static final VariableDeclaration<Double> FLARE_BANK_LIMIT =
      number("FLARE BANK LIMIT", "deg", 0.0, 12.0, 8.0, "Most bank demanded in the flare.");
  static final VariableDeclaration<Double> FLARE_LOOK_AHEAD =
      number(
          "FLARE LOOK AHEAD",
          "m",
          50.0,
          500.0,
          120.0,
          "To the point steered for on the runway's centreline in the flare.");
  static final VariableDeclaration<Double> SIDESLIP_AILERON =
      number(
          "AILERON PER SIDESLIP",
          "1/rad",
          0.0,
          5.0,
          1.6,
          "Aileron that keeps the wind from lifting a wing where the nose is held along the runway:"
              + " dihedral over aileron effect.");
  static final VariableDeclaration<Double> BRAKE_SPEED =
      number(
          "BRAKE SPEED",
          "m/s",
          10.0,
          40.0,
          28.0,
          "Speed over ground above which the brakes are hardly used; slower they come on by degrees.");
  static final VariableDeclaration<Double> MAX_CROSSWIND =
      number(
          "MAX CROSSWIND",
          "m/s",
          0.0,
          20.0,
          15.0,
          "Most wind across the approach, as the aircraft feels it, in which it lands; in more it"
              + " stays at SAFE HEIGHT.");

  private LandingVariables() {}

  static TouchDown.Parameters touchDown(Configurator c) {
    return new TouchDown.Parameters(
        c.getVariable(ALIGN_HEIGHT),
        Math.toRadians(c.getVariable(FLARE_BANK_LIMIT)),
        c.getVariable(FLARE_LOOK_AHEAD),
        c.getVariable(SIDESLIP_AILERON),
        c.getVariable(BRAKE_SPEED));
  }

  static Tuning.Hold hold(Configurator c) {
    return new Tuning.Hold(
        c.getVariable(HOLD_LEVEL_TIME), Math.toRadians(c.getVariable(HOLD_BANK)));
  }

  static FlareLaw.Parameters flare(Configurator c) {
    return new FlareLaw.Parameters(
        c.getVariable(FLARE_HEIGHT),
        c.getVariable(FLARE_TIME),
        c.getVariable(FLARE_SINK),
        c.getVariable(FLARE_DAMPING),
        c.getVariable(FLARE_GAIN),
        Math.toRadians(c.getVariable(FLARE_PITCH_LIMIT)));
  }
}
