package org.u2sa.core.control.fixedwing;

import static org.u2sa.core.control.fixedwing.BoundedNumber.number;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** How the aircraft leaves the ground. */
final class TakeOffVariables {
  private static final double KNOT_MPS = 1852.0 / 3600.0;

  static final VariableDeclaration<Double> READY_RPM =
      number(
          "READY RPM",
          "rpm",
          0.0,
          2000.0,
          600.0,
          "Engine speed from which the engine runs by itself.");
  static final VariableDeclaration<Double> READY_TIME =
      number(
          "READY TIME",
          "s",
          0.0,
          60.0,
          1.0,
          "How long engine and navigation must be there before the throttle opens.");
  static final VariableDeclaration<Double> START_THROTTLE =
      number("START THROTTLE", "", 0.1, 0.5, 0.2, "Throttle while the engine starts.");
  static final VariableDeclaration<Double> RELEASE_THROTTLE =
      number("RELEASE THROTTLE", "", 0.1, 1.0, 0.5, "Throttle at which the brakes are let go.");
  static final VariableDeclaration<Double> THROTTLE_OPENING =
      number(
          "THROTTLE OPENING RATE",
          "1/s",
          0.05,
          5.0,
          0.3,
          "How fast the throttle opens for take-off.");
  static final VariableDeclaration<Double> ROTATION_SPEED =
      number(
          "ROTATION SPEED",
          "kt",
          40.0,
          80.0,
          55.0,
          "Calibrated airspeed at which the nose is raised.");
  static final VariableDeclaration<Double> ROTATION_PITCH =
      number("ROTATION PITCH", "deg", 5.0, 13.0, 10.0, "To which the nose is raised.");
  static final VariableDeclaration<Double> ROTATION_RATE =
      number("ROTATION RATE", "deg/s", 1.0, 10.0, 5.0, "How fast the nose is raised.");
  static final VariableDeclaration<Double> CLIMB_OUT_SPEED =
      number("CLIMB OUT SPEED", "kt", 60.0, 100.0, 74.0, "Calibrated airspeed of the climb-out.");
  static final VariableDeclaration<Double> CLIMB_OUT_PITCH =
      number(
          "CLIMB OUT PITCH LOWER LIMIT",
          "deg",
          0.0,
          10.0,
          6.0,
          "Least pitch demanded in the climb-out.");
  static final VariableDeclaration<Double> CLIMB_OUT_BANK =
      number(
          "CLIMB OUT BANK LIMIT", "deg", 0.0, 30.0, 10.0, "Most bank demanded in the climb-out.");
  static final VariableDeclaration<Double> CLIMB_OUT_LOOK_AHEAD =
      number(
          "CLIMB OUT LOOK AHEAD",
          "m",
          50.0,
          2000.0,
          250.0,
          "To the point steered for on the extended centreline.");
  static final VariableDeclaration<Double> SAFE_HEIGHT =
      number("SAFE HEIGHT", "m", 20.0, 500.0, 100.0, "Above ground, at which the climb-out ends.");
  static final VariableDeclaration<Double> LOOK_AHEAD_TIME =
      number(
          "CENTRELINE LOOK AHEAD TIME",
          "s",
          0.5,
          10.0,
          2.5,
          "To the point steered for on the runway, at the present speed.");
  static final VariableDeclaration<Double> LOOK_AHEAD_LEAST =
      number(
          "CENTRELINE LOOK AHEAD",
          "m",
          5.0,
          200.0,
          40.0,
          "Least distance to the point steered for on the runway.");
  static final VariableDeclaration<Double> HEADING_GAIN =
      number(
          "CENTRELINE HEADING GAIN",
          "1/s",
          0.1,
          5.0,
          1.8,
          "Yaw rate per heading error on the runway.");
  static final VariableDeclaration<Double> STEERING_LENGTH =
      number(
          "STEERING LENGTH",
          "m/rad",
          1.0,
          50.0,
          9.5,
          "Wheel base over the angle of the nose wheel at full rudder.");
  static final VariableDeclaration<Double> STEERING_DAMPING =
      number(
          "STEERING DAMPING",
          "s/rad",
          0.0,
          5.0,
          1.6,
          "Rudder per yaw rate error at 10 m/s, nose wheel down.");
  static final VariableDeclaration<Double> STEERING_INTEGRAL =
      number(
          "STEERING INTEGRAL GAIN",
          "1/rad",
          0.0,
          5.0,
          1.2,
          "Rudder per integrated yaw rate error at 10 m/s, nose wheel down.");
  static final VariableDeclaration<Double> ROTATION_DAMPING =
      number(
          "ROTATION YAW DAMPING",
          "s/rad",
          0.0,
          5.0,
          1.5,
          "Rudder per yaw rate error, nose wheel up.");
  static final VariableDeclaration<Double> ROTATION_INTEGRAL =
      number(
          "ROTATION YAW INTEGRAL GAIN",
          "1/rad",
          0.0,
          5.0,
          1.5,
          "Rudder per integrated yaw rate error, nose wheel up.");
  static final VariableDeclaration<Double> WEATHERCOCK =
      number(
          "WEATHERCOCK GAIN",
          "1/rad",
          0.0,
          5.0,
          1.2,
          "Rudder per sideslip, nose wheel up, against the wind on the fin.");
  static final VariableDeclaration<Double> INTO_WIND =
      number(
          "AILERON INTO WIND",
          "s/m",
          0.0,
          1.0,
          0.1,
          "Aileron per metre per second of crosswind when standing.");

  private TakeOffVariables() {}

  static TakeOffSequence.Parameters takeOff(Configurator c) {
    return new TakeOffSequence.Parameters(
        c.getVariable(READY_RPM),
        c.getVariable(READY_TIME),
        c.getVariable(RELEASE_THROTTLE),
        KNOT_MPS * c.getVariable(ROTATION_SPEED),
        c.getVariable(SAFE_HEIGHT));
  }

  static GroundSteering.Parameters ground(Configurator c) {
    return new GroundSteering.Parameters(
        c.getVariable(LOOK_AHEAD_TIME),
        c.getVariable(LOOK_AHEAD_LEAST),
        c.getVariable(HEADING_GAIN),
        c.getVariable(STEERING_LENGTH),
        c.getVariable(STEERING_DAMPING),
        c.getVariable(STEERING_INTEGRAL),
        c.getVariable(ROTATION_DAMPING),
        c.getVariable(ROTATION_INTEGRAL),
        c.getVariable(WEATHERCOCK),
        c.getVariable(INTO_WIND));
  }

  static Tuning.ClimbOut climbOut(Configurator c) {
    return new Tuning.ClimbOut(
        c.getVariable(START_THROTTLE),
        c.getVariable(THROTTLE_OPENING),
        Math.toRadians(c.getVariable(ROTATION_PITCH)),
        Math.toRadians(c.getVariable(ROTATION_RATE)),
        KNOT_MPS * c.getVariable(CLIMB_OUT_SPEED),
        Math.toRadians(c.getVariable(CLIMB_OUT_PITCH)),
        Math.toRadians(c.getVariable(CLIMB_OUT_BANK)),
        c.getVariable(CLIMB_OUT_LOOK_AHEAD));
  }
}
