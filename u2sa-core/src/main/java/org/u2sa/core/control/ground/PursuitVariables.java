package org.u2sa.core.control.ground;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The variables of regulated pure pursuit, for every kind of ground vehicle. */
final class PursuitVariables {
  static final VariableDeclaration<Double> CRUISE_SPEED =
      number(
          "CRUISE SPEED", "m/s", 0.05, 20.0, 1.0, "Speed on a straight, unless the goal says one.");
  static final VariableDeclaration<Double> ACCELERATION =
      number("ACCELERATION", "m/s^2", 0.05, 10.0, 0.8, "With which the vehicle gets faster.");
  static final VariableDeclaration<Double> BRAKING =
      number("BRAKING", "m/s^2", 0.05, 10.0, 1.2, "With which the vehicle gets slower.");
  static final VariableDeclaration<Double> APPROACH_DISTANCE =
      number(
          "APPROACH DISTANCE",
          "m",
          0.05,
          100.0,
          1.0,
          "Distance to the point to go to from which on the vehicle slows down; less than the planner's LOOK AHEAD.");
  static final VariableDeclaration<Double> APPROACH_SPEED =
      number("APPROACH SPEED", "m/s", 0.01, 5.0, 0.15, "Least speed on the way to a point.");
  static final VariableDeclaration<Double> TOLERANCE =
      number(
          "TOLERANCE",
          "m",
          0.01,
          10.0,
          0.15,
          "Distance at which the vehicle has arrived and stands; less than the thresholds of waypoints.");
  static final VariableDeclaration<Double> REGULATED_RADIUS =
      number(
          "REGULATED RADIUS",
          "m",
          0.0,
          100.0,
          0.9,
          "Curves of a smaller radius are driven slower, in proportion.");
  static final VariableDeclaration<Double> TURN_RATE =
      number("TURN RATE", "deg/s", 1.0, 720.0, 70.0, "Most yaw rate.");
  static final VariableDeclaration<Double> TURN_ACCELERATION =
      number(
          "TURN RATE CHANGE", "deg/s^2", 1.0, 7200.0, 180.0, "How fast the yaw rate may change.");

  static final VariableDeclaration<Double> SPEED_GAIN =
      number(
          "SPEED GAIN",
          "1/s",
          0.0,
          10.0,
          0.5,
          "Share of an error of the speed that feedback takes out in a second; 0: no feedback.");
  static final VariableDeclaration<Double> TURN_GAIN =
      number(
          "TURN GAIN",
          "1/s",
          0.0,
          10.0,
          1.0,
          "Share of an error of the yaw rate that feedback takes out in a second while driving; 0: no feedback.");
  static final VariableDeclaration<Double> YAW_RATE_GAIN =
      number(
          "YAW RATE GAIN",
          "",
          0.0,
          10.0,
          2.0,
          "Yaw rate commanded more for each deg/s by which the measured one falls short; 0: none.");
  static final VariableDeclaration<Double> RESPONSE_TIME =
      number(
          "RESPONSE TIME",
          "s",
          0.0,
          5.0,
          0.3,
          "How late the measured motion follows the commanded one, sensors included.");
  static final VariableDeclaration<Double> STALL_TIME =
      number(
          "STALL TIME",
          "s",
          0.2,
          60.0,
          3.0,
          "How long motors at full power may hardly move the vehicle, before it is said and they rest.");
  static final VariableDeclaration<Double> STALL_PAUSE =
      number(
          "STALL PAUSE",
          "s",
          0.0,
          600.0,
          10.0,
          "How long the motors rest then, before the vehicle tries again.");

  private PursuitVariables() {}

  static VariableDeclaration<Double> number(
      String name, String unit, double least, double most, double ifAbsent, String meaning) {
    return VariableDeclaration.number(name, unit)
        .range(Range.of(least, most))
        .ifAbsent(ifAbsent)
        .describedAs(meaning);
  }

  /**
   * Declares and reads them.
   *
   * @param largestCurvature that the vehicle can drive [1/m]
   */
  static PursuitSettings settings(
      Configurator configuration, double largestCurvature, PursuitSettings.SpotTurn spotTurn) {
    return new PursuitSettings(
        configuration.getVariable(CRUISE_SPEED),
        configuration.getVariable(ACCELERATION),
        configuration.getVariable(BRAKING),
        configuration.getVariable(APPROACH_DISTANCE),
        configuration.getVariable(APPROACH_SPEED),
        configuration.getVariable(TOLERANCE),
        configuration.getVariable(REGULATED_RADIUS),
        largestCurvature,
        Math.toRadians(configuration.getVariable(TURN_RATE)),
        Math.toRadians(configuration.getVariable(TURN_ACCELERATION)),
        spotTurn);
  }
}
