package org.u2sa.core.control.fixedwing;

import static org.u2sa.core.control.fixedwing.BoundedNumber.number;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** Speeds and limits within which the aircraft follows navigation. */
final class GuidanceVariables {
  static final VariableDeclaration<Double> CRUISE_SPEED =
      number(
          "CRUISE SPEED",
          "m/s",
          30.0,
          60.0,
          40.0,
          "Calibrated airspeed where navigation asks for none.");
  static final VariableDeclaration<Double> FASTEST_SPEED =
      number("FASTEST SPEED", "m/s", 35.0, 82.0, 60.0, "Most calibrated airspeed demanded.");
  static final VariableDeclaration<Double> BANK_LIMIT =
      number("BANK LIMIT", "deg", 5.0, 30.0, 27.5, "Most bank demanded.");
  static final VariableDeclaration<Double> BANK_RATE =
      number("BANK RATE LIMIT", "deg/s", 2.0, 60.0, 15.0, "How fast the demanded bank may move.");
  static final VariableDeclaration<Double> SHORTEST_LOOK_AHEAD =
      number(
          "SHORTEST LOOK AHEAD",
          "m",
          50.0,
          1000.0,
          150.0,
          "A navigation point nearer than this counts as this far, which bounds the gain.");
  static final VariableDeclaration<Double> STALL_SPEED =
      number(
          "STALL SPEED",
          "m/s",
          15.0,
          40.0,
          26.2,
          "Calibrated airspeed of the stall, wings level, flaps up.");
  static final VariableDeclaration<Double> STALL_MARGIN =
      number(
          "STALL MARGIN",
          "",
          1.05,
          2.0,
          1.2,
          "Least airspeed over stall speed; the bank is limited so that it holds in turns.");
  static final VariableDeclaration<Double> STALL_BAND =
      number(
          "STALL BAND",
          "m/s",
          0.5,
          15.0,
          4.0,
          "Above the least airspeed, in which speed gains priority over altitude.");
  static final VariableDeclaration<Double> GUST_SHARE =
      number(
          "GUST SHARE",
          "",
          0.0,
          1.0,
          0.3,
          "Share of the wind's speed that is added to the rotation speed and the least speed: near"
              + " the ground gusts are as strong (MIL-F-8785C: σ about 0.2).");
  static final VariableDeclaration<Double> ALPHA_LIMIT =
      number(
          "ANGLE OF ATTACK LIMIT",
          "deg",
          5.0,
          18.0,
          12.0,
          "Above it the nose is lowered by the excess.");
  static final VariableDeclaration<Double> TURN_PITCH =
      number("TURN PITCH", "deg", 0.0, 20.0, 6.9, "Pitch added per load factor above one.");
  static final VariableDeclaration<Double> PITCH_LOWER_LIMIT =
      number("PITCH LOWER LIMIT", "deg", -30.0, 0.0, -10.0, "Least pitch demanded.");
  static final VariableDeclaration<Double> PITCH_UPPER_LIMIT =
      number("PITCH UPPER LIMIT", "deg", 5.0, 30.0, 14.0, "Most pitch demanded.");

  private GuidanceVariables() {}

  static StallGuard.Parameters stall(Configurator c) {
    return new StallGuard.Parameters(
        c.getVariable(STALL_SPEED),
        c.getVariable(STALL_MARGIN),
        c.getVariable(STALL_BAND),
        Math.toRadians(c.getVariable(ALPHA_LIMIT)));
  }

  /** Why speeds, each allowed, do not go together; empty if they do. */
  static Optional<String> refusal(Map<String, Object> values) {
    double cruiseMps = (Double) values.get(CRUISE_SPEED.name());
    double fastestMps = (Double) values.get(FASTEST_SPEED.name());
    double leastMps =
        (Double) values.get(STALL_SPEED.name()) * (Double) values.get(STALL_MARGIN.name());
    if (cruiseMps > fastestMps) {
      return Optional.of(
          "CRUISE SPEED " + cruiseMps + " m/s is above FASTEST SPEED " + fastestMps + " m/s");
    }
    return leastMps < cruiseMps
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "STALL SPEED times STALL MARGIN is %.1f m/s, expected less than CRUISE SPEED %.1f m/s",
                leastMps,
                cruiseMps));
  }

  /** All that the configuration says. */
  static Tuning tuning(Configurator c) {
    return new Tuning(
        SurfaceVariables.referenceSpeedMps(c),
        c.getVariable(CRUISE_SPEED),
        c.getVariable(FASTEST_SPEED),
        Math.toRadians(c.getVariable(BANK_LIMIT)),
        Math.toRadians(c.getVariable(BANK_RATE)),
        Math.toRadians(c.getVariable(TURN_PITCH)),
        Math.toRadians(c.getVariable(PITCH_LOWER_LIMIT)),
        Math.toRadians(c.getVariable(PITCH_UPPER_LIMIT)),
        c.getVariable(SHORTEST_LOOK_AHEAD),
        SurfaceVariables.roll(c),
        SurfaceVariables.pitch(c),
        SurfaceVariables.yaw(c),
        stall(c),
        EnergyVariables.energy(c),
        TakeOffVariables.takeOff(c),
        TakeOffVariables.ground(c),
        TakeOffVariables.climbOut(c),
        LandingVariables.hold(c),
        LandingVariables.flare(c),
        LandingVariables.touchDown(c),
        c.getVariable(LandingVariables.MAX_CROSSWIND),
        c.getVariable(GUST_SHARE));
  }
}
