package org.u2sa.core.control.ground;

import org.u2sa.interfaces.Configurator;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;

/** The variables of regulated pure pursuit, for every kind of ground vehicle. */
final class PursuitVariables {
  static final Variable<Double> CRUISE_SPEED =
      number(
          "CRUISE SPEED", "m/s", 0.05, 20.0, 1.0, "Speed on a straight, unless the goal says one.");
  static final Variable<Double> ACCELERATION =
      number("ACCELERATION", "m/s^2", 0.05, 10.0, 0.8, "With which the vehicle gets faster.");
  static final Variable<Double> BRAKING =
      number("BRAKING", "m/s^2", 0.05, 10.0, 1.2, "With which the vehicle gets slower.");
  static final Variable<Double> APPROACH_DISTANCE =
      number(
          "APPROACH DISTANCE",
          "m",
          0.05,
          100.0,
          1.0,
          "Distance to the point to go to from which on the vehicle slows down; less than the planner's LOOK AHEAD.");
  static final Variable<Double> APPROACH_SPEED =
      number("APPROACH SPEED", "m/s", 0.01, 5.0, 0.15, "Least speed on the way to a point.");
  static final Variable<Double> TOLERANCE =
      number(
          "TOLERANCE",
          "m",
          0.01,
          10.0,
          0.15,
          "Distance at which the vehicle has arrived and stands; less than the thresholds of waypoints.");
  static final Variable<Double> REGULATED_RADIUS =
      number(
          "REGULATED RADIUS",
          "m",
          0.0,
          100.0,
          0.9,
          "Curves of a smaller radius are driven slower, in proportion.");
  static final Variable<Double> TURN_RATE =
      number("TURN RATE", "deg/s", 1.0, 720.0, 70.0, "Most yaw rate.");
  static final Variable<Double> TURN_ACCELERATION =
      number(
          "TURN RATE CHANGE", "deg/s^2", 1.0, 7200.0, 180.0, "How fast the yaw rate may change.");

  static final Variable<Double> SPEED_GAIN =
      number(
          "SPEED GAIN",
          "1/s",
          0.0,
          10.0,
          0.2,
          "How fast the commanded speed follows the measured one's error; 0: no feedback.");
  static final Variable<Double> SPEED_TRIM =
      number(
          "SPEED TRIM LIMIT",
          "m/s",
          0.0,
          10.0,
          0.3,
          "Most by which feedback changes the commanded speed.");
  static final Variable<Double> TURN_GAIN =
      number(
          "TURN GAIN",
          "1/s",
          0.0,
          10.0,
          0.5,
          "How fast the commanded yaw rate follows the error of the compass's; 0: no feedback.");
  static final Variable<Double> TURN_TRIM =
      number(
          "TURN TRIM LIMIT",
          "deg/s",
          0.0,
          90.0,
          20.0,
          "Most by which feedback changes the commanded yaw rate: motors that are not alike.");

  private PursuitVariables() {}

  static Variable<Double> number(
      String name, String unit, double least, double most, double ifAbsent, String meaning) {
    return Variable.number(name, unit)
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
