package org.u2sa.control.fixedwing;

/**
 * Actuator commands of the control laws.
 *
 * <p>The elevons of a flying wing move together as an elevator and against each other as ailerons;
 * a positive command lowers the trailing edge.
 *
 * @param aileron −1…1, positive rolls right
 * @param elevator −1…1, positive lowers the nose
 * @param rudder −1…1, positive yaws right and steers the nose wheel to the right
 * @param throttle 0…1
 * @param mixture 0…1, 1 is rich
 * @param flaps 0…1
 * @param brakes 0…1, both wheels
 */
record Surfaces(
    double aileron,
    double elevator,
    double rudder,
    double throttle,
    double mixture,
    double flaps,
    double brakes) {
  static final String LEFT_ELEVON = "LEFT ELEVON";
  static final String RIGHT_ELEVON = "RIGHT ELEVON";

  /** Command of the left elevon, −1…1. */
  double leftElevon() {
    return Limit.symmetric(elevator + aileron, 1.0);
  }

  /** Command of the right elevon, −1…1. */
  double rightElevon() {
    return Limit.symmetric(elevator - aileron, 1.0);
  }
}
