package org.u2sa.core.control.fixedwing;

import static org.u2sa.core.control.fixedwing.BoundedNumber.number;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** Gains and limits of altitude and airspeed: {@link EnergyParameters}. */
final class EnergyVariables {
  static final VariableDeclaration<Double> ALTITUDE_TIME =
      number(
          "ALTITUDE TIME CONSTANT",
          "s",
          1.0,
          30.0,
          4.0,
          "In which an altitude error is taken out.");
  static final VariableDeclaration<Double> SPEED_TIME =
      number(
          "SPEED TIME CONSTANT", "s", 1.0, 30.0, 6.0, "In which an airspeed error is taken out.");
  static final VariableDeclaration<Double> CLIMB_LIMIT =
      number("CLIMB LIMIT", "m/s", 0.5, 10.0, 3.5, "Most climb demanded.");
  static final VariableDeclaration<Double> SINK_LIMIT =
      number("SINK LIMIT", "m/s", 0.5, 10.0, 4.0, "Most descent demanded.");
  static final VariableDeclaration<Double> VERTICAL_ACCELERATION =
      number(
          "VERTICAL ACCELERATION LIMIT",
          "m/s^2",
          0.1,
          5.0,
          0.8,
          "How fast the demanded climb may change.");
  static final VariableDeclaration<Double> ACCELERATION =
      number(
          "ACCELERATION LIMIT",
          "m/s^2",
          0.1,
          5.0,
          1.0,
          "Most acceleration along the path demanded.");
  static final VariableDeclaration<Double> AIRSPEED_FILTER =
      number(
          "AIRSPEED FILTER",
          "s",
          0.05,
          20.0,
          1.0,
          "Time constant of the low pass on airspeed: longer is calmer in gusts.");
  static final VariableDeclaration<Double> THROTTLE_TRIM =
      number(
          "THROTTLE TRIM",
          "",
          0.0,
          1.0,
          0.6,
          "Throttle of level cruise, where the integral begins.");
  static final VariableDeclaration<Double> THROTTLE_FORWARD =
      number(
          "THROTTLE FORWARD GAIN", "1/rad", 0.0, 20.0, 2.5, "Throttle per demanded energy rate.");
  static final VariableDeclaration<Double> THROTTLE_DAMPING =
      number("THROTTLE DAMPING", "1/rad", 0.0, 20.0, 0.7, "Throttle per energy rate error.");
  static final VariableDeclaration<Double> THROTTLE_INTEGRAL =
      number(
          "THROTTLE INTEGRAL GAIN",
          "1/rad/s",
          0.0,
          20.0,
          0.4,
          "Throttle per integrated energy rate error.");
  static final VariableDeclaration<Double> THROTTLE_LOWER_LIMIT =
      number("THROTTLE LOWER LIMIT", "", 0.0, 1.0, 0.0, "Least throttle in flight.");
  static final VariableDeclaration<Double> THROTTLE_UPPER_LIMIT =
      number("THROTTLE UPPER LIMIT", "", 0.0, 1.0, 1.0, "Most throttle in cruise.");
  static final VariableDeclaration<Double> THROTTLE_RATE =
      number(
          "THROTTLE RATE LIMIT", "1/s", 0.01, 5.0, 0.3, "How fast the throttle moves in flight.");
  static final VariableDeclaration<Double> TURN_DRAG =
      number(
          "TURN DRAG",
          "rad",
          0.0,
          0.5,
          0.037,
          "Induced drag over weight in level flight; grows in turns with the square of the load factor.");
  static final VariableDeclaration<Double> PITCH_DAMPING =
      number("ENERGY BALANCE GAIN", "", 0.0, 5.0, 0.8, "Pitch per energy balance error.");
  static final VariableDeclaration<Double> PITCH_INTEGRAL =
      number(
          "ENERGY BALANCE INTEGRAL GAIN",
          "1/s",
          0.0,
          5.0,
          0.3,
          "Pitch per integrated energy balance error.");
  static final VariableDeclaration<Double> PITCH_RATE =
      number(
          "PITCH DEMAND RATE LIMIT",
          "deg/s",
          0.5,
          20.0,
          3.0,
          "How fast the demanded pitch may move.");
  static final VariableDeclaration<Double> SLOWEST =
      number(
          "SLOWEST SPEED",
          "m/s",
          5.0,
          40.0,
          20.0,
          "Airspeed below which flight path angles mean nothing.");

  private EnergyVariables() {}

  static EnergyParameters energy(Configurator c) {
    return new EnergyParameters(
        c.getVariable(ALTITUDE_TIME),
        c.getVariable(SPEED_TIME),
        c.getVariable(CLIMB_LIMIT),
        c.getVariable(SINK_LIMIT),
        c.getVariable(VERTICAL_ACCELERATION),
        c.getVariable(ACCELERATION),
        c.getVariable(AIRSPEED_FILTER),
        c.getVariable(THROTTLE_TRIM),
        c.getVariable(THROTTLE_FORWARD),
        c.getVariable(THROTTLE_DAMPING),
        c.getVariable(THROTTLE_INTEGRAL),
        c.getVariable(THROTTLE_LOWER_LIMIT),
        c.getVariable(THROTTLE_UPPER_LIMIT),
        c.getVariable(THROTTLE_RATE),
        c.getVariable(TURN_DRAG),
        c.getVariable(PITCH_DAMPING),
        c.getVariable(PITCH_INTEGRAL),
        Math.toRadians(c.getVariable(PITCH_RATE)),
        c.getVariable(SLOWEST));
  }
}
