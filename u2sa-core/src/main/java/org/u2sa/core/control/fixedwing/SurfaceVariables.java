package org.u2sa.core.control.fixedwing;

import static org.u2sa.core.control.fixedwing.BoundedNumber.number;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** Gains of the loops that move aileron, elevator and rudder. */
final class SurfaceVariables {
  static final VariableDeclaration<Double> REFERENCE_SPEED =
      number(
          "REFERENCE SPEED",
          "m/s",
          20.0,
          100.0,
          46.0,
          "Calibrated airspeed at which the surface gains hold; they are scaled from there.");
  static final VariableDeclaration<Double> BANK_TIME =
      number("BANK TIME CONSTANT", "s", 0.2, 5.0, 0.65, "In which a bank error is taken out.");
  static final VariableDeclaration<Double> ROLL_RATE_LIMIT =
      number("ROLL RATE LIMIT", "deg/s", 2.0, 60.0, 20.0, "Most roll rate demanded.");
  static final VariableDeclaration<Double> ROLL_FORWARD =
      number("ROLL RATE FORWARD GAIN", "s/rad", 0.0, 5.0, 1.1, "Aileron per demanded roll rate.");
  static final VariableDeclaration<Double> ROLL_GAIN =
      number("ROLL RATE GAIN", "s/rad", 0.0, 5.0, 0.2, "Aileron per roll rate error.");
  static final VariableDeclaration<Double> ROLL_INTEGRAL =
      number(
          "ROLL RATE INTEGRAL GAIN",
          "1/rad",
          0.0,
          5.0,
          0.1,
          "Aileron per integrated roll rate error.");
  static final VariableDeclaration<Double> AILERON_TRIM =
      number(
          "AILERON TRIM LIMIT",
          "",
          0.0,
          1.0,
          0.4,
          "Most of the aileron that the integral may hold.");
  static final VariableDeclaration<Double> PITCH_TIME =
      number("PITCH TIME CONSTANT", "s", 0.2, 5.0, 0.8, "In which a pitch error is taken out.");
  static final VariableDeclaration<Double> PITCH_RATE_LIMIT =
      number(
          "PITCH RATE LIMIT",
          "deg/s",
          1.0,
          30.0,
          10.0,
          "Most pitch rate demanded for a pitch error.");
  static final VariableDeclaration<Double> PITCH_FORWARD =
      number(
          "PITCH RATE FORWARD GAIN", "s/rad", 0.0, 5.0, 0.5, "Elevator per demanded pitch rate.");
  static final VariableDeclaration<Double> PITCH_GAIN =
      number("PITCH RATE GAIN", "s/rad", 0.0, 5.0, 0.18, "Elevator per pitch rate error.");
  static final VariableDeclaration<Double> PITCH_INTEGRAL =
      number(
          "PITCH RATE INTEGRAL GAIN",
          "1/rad",
          0.0,
          5.0,
          0.7,
          "Elevator per integrated pitch rate error.");
  static final VariableDeclaration<Double> ELEVATOR_TRIM =
      number(
          "ELEVATOR TRIM LIMIT",
          "",
          0.0,
          1.0,
          0.6,
          "Most of the elevator that the integral may hold.");
  static final VariableDeclaration<Double> YAW_DAMPING =
      number(
          "YAW DAMPING",
          "s/rad",
          0.0,
          5.0,
          0.5,
          "Rudder per difference from the yaw rate of a coordinated turn.");
  static final VariableDeclaration<Double> SIDESLIP_GAIN =
      number("SIDESLIP GAIN", "1/rad", 0.0, 5.0, 0.8, "Rudder per sideslip.");
  static final VariableDeclaration<Double> SIDESLIP_INTEGRAL =
      number("SIDESLIP INTEGRAL GAIN", "1/rad/s", 0.0, 5.0, 0.4, "Rudder per integrated sideslip.");
  static final VariableDeclaration<Double> RUDDER_TRIM =
      number(
          "RUDDER TRIM LIMIT", "", 0.0, 1.0, 0.5, "Most of the rudder that the integral may hold.");
  static final VariableDeclaration<Double> AILERON_TO_RUDDER =
      number("AILERON TO RUDDER", "", 0.0, 1.0, 0.45, "Rudder per aileron, against adverse yaw.");

  private SurfaceVariables() {}

  static double referenceSpeedMps(Configurator configuration) {
    return configuration.getVariable(REFERENCE_SPEED);
  }

  static RollLaw.Parameters roll(Configurator c) {
    return new RollLaw.Parameters(
        c.getVariable(BANK_TIME),
        Math.toRadians(c.getVariable(ROLL_RATE_LIMIT)),
        new RateLoop.Gains(
            c.getVariable(ROLL_FORWARD),
            c.getVariable(ROLL_GAIN),
            c.getVariable(ROLL_INTEGRAL),
            c.getVariable(AILERON_TRIM)));
  }

  static PitchLaw.Parameters pitch(Configurator c) {
    return new PitchLaw.Parameters(
        c.getVariable(PITCH_TIME),
        Math.toRadians(c.getVariable(PITCH_RATE_LIMIT)),
        new RateLoop.Gains(
            c.getVariable(PITCH_FORWARD),
            c.getVariable(PITCH_GAIN),
            c.getVariable(PITCH_INTEGRAL),
            c.getVariable(ELEVATOR_TRIM)));
  }

  static YawLaw.Parameters yaw(Configurator c) {
    return new YawLaw.Parameters(
        c.getVariable(YAW_DAMPING),
        c.getVariable(SIDESLIP_GAIN),
        c.getVariable(SIDESLIP_INTEGRAL),
        c.getVariable(RUDDER_TRIM),
        c.getVariable(AILERON_TO_RUDDER));
  }
}
