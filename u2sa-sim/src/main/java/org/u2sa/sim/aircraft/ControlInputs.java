package org.u2sa.sim.aircraft;

import java.util.List;
import org.u2sa.sim.motion.Arguments;

/**
 * Normalised pilot inputs; signs follow FlightGear.
 *
 * @param aileron −1…1, positive rolls right
 * @param elevator −1…1, positive is stick forward: nose down
 * @param rudder −1…1, positive yaws right; also steers the nose wheel
 * @param throttle 0 (idle) … 1 (full)
 * @param mixture 0 (cut-off) … 1 (full rich)
 * @param flaps 0 (up) … 1 (30°); the flap motor limits the rate
 * @param brakeLeft 0…1, left main wheel
 * @param brakeRight 0…1, right main wheel
 */
public record ControlInputs(
    double aileron,
    double elevator,
    double rudder,
    double throttle,
    double mixture,
    double flaps,
    double brakeLeft,
    double brakeRight) {

  /**
   * @throws IllegalArgumentException if a value is not a number or outside its range
   */
  public ControlInputs {
    Arguments.requireInside("aileron", aileron, -1.0, 1.0);
    Arguments.requireInside("elevator", elevator, -1.0, 1.0);
    Arguments.requireInside("rudder", rudder, -1.0, 1.0);
    Arguments.requireInside("throttle", throttle, 0.0, 1.0);
    Arguments.requireInside("mixture", mixture, 0.0, 1.0);
    Arguments.requireInside("flaps", flaps, 0.0, 1.0);
    Arguments.requireInside("brakeLeft", brakeLeft, 0.0, 1.0);
    Arguments.requireInside("brakeRight", brakeRight, 0.0, 1.0);
  }

  /** Names of all inputs in order, as used in actuator commands. */
  static final List<String> NAMES =
      List.of(
          "AILERON",
          "ELEVATOR",
          "RUDDER",
          "THROTTLE",
          "MIXTURE",
          "FLAPS",
          "LEFT BRAKE",
          "RIGHT BRAKE");

  /** Surfaces centred, throttle idle, mixture rich, flaps up, brakes off. */
  public static ControlInputs neutral() {
    return new ControlInputs(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
  }

  /**
   * Clamps finite values to their ranges, for inputs received over a link. @throws
   * IllegalArgumentException if one is not finite
   */
  public static ControlInputs limited(
      double aileron,
      double elevator,
      double rudder,
      double throttle,
      double mixture,
      double flaps,
      double brakeLeft,
      double brakeRight) {
    return new ControlInputs(
        limit("aileron", aileron, -1.0),
        limit("elevator", elevator, -1.0),
        limit("rudder", rudder, -1.0),
        limit("throttle", throttle, 0.0),
        limit("mixture", mixture, 0.0),
        limit("flaps", flaps, 0.0),
        limit("brakeLeft", brakeLeft, 0.0),
        limit("brakeRight", brakeRight, 0.0));
  }

  /** Copy with one of {@link #NAMES} set; NaN, i.e. no signal, gives {@link #neutral}'s. */
  ControlInputs with(String name, double value) {
    if (Double.isNaN(value)) {
      return with(name, name.equals("MIXTURE") ? neutral().mixture : 0.0);
    }
    return switch (name) {
      case "AILERON" -> withSurfaces(value, elevator, rudder);
      case "ELEVATOR" -> withSurfaces(aileron, value, rudder);
      case "RUDDER" -> withSurfaces(aileron, elevator, value);
      case "THROTTLE" -> withThrottle(value);
      case "MIXTURE" -> withMixture(value);
      case "FLAPS" -> withFlaps(value);
      case "LEFT BRAKE" -> withBrakes(value, brakeRight);
      case "RIGHT BRAKE" -> withBrakes(brakeLeft, value);
      default ->
          throw new IllegalArgumentException("actuator \"" + name + "\": expected one of " + NAMES);
    };
  }

  /** Copy with new aileron, elevator and rudder. */
  public ControlInputs withSurfaces(double newAileron, double newElevator, double newRudder) {
    return new ControlInputs(
        newAileron, newElevator, newRudder, throttle, mixture, flaps, brakeLeft, brakeRight);
  }

  /** Copy with a new throttle. */
  public ControlInputs withThrottle(double newThrottle) {
    return new ControlInputs(
        aileron, elevator, rudder, newThrottle, mixture, flaps, brakeLeft, brakeRight);
  }

  /** Copy with a new mixture. */
  public ControlInputs withMixture(double newMixture) {
    return new ControlInputs(
        aileron, elevator, rudder, throttle, newMixture, flaps, brakeLeft, brakeRight);
  }

  /** Copy with new flaps. */
  public ControlInputs withFlaps(double newFlaps) {
    return new ControlInputs(
        aileron, elevator, rudder, throttle, mixture, newFlaps, brakeLeft, brakeRight);
  }

  /** Copy with new brakes. */
  public ControlInputs withBrakes(double newLeft, double newRight) {
    return new ControlInputs(
        aileron, elevator, rudder, throttle, mixture, flaps, newLeft, newRight);
  }

  private static double limit(String name, double value, double lowest) {
    return Math.min(1.0, Math.max(lowest, Arguments.requireFinite(name, value)));
  }
}
