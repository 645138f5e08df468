package org.u2sa.core.control.fixedwing;

import org.u2sa.service.HandOver;

/**
 * Keeps the runway's centreline by rudder and nose wheel: aims at a point ahead on the line, turns
 * at a rate proportional to the heading error, and finds the rudder from the geometry of a steered
 * wheel, ψ̇ = V/L · δ, whose effect grows with speed. Proportion on the rate is divided by speed
 * likewise; the integral meets propeller and crosswind.
 */
final class GroundSteering {
  /**
   * @param lookAheadS point ahead, in seconds at the present speed
   * @param shortestM least distance to it [m]
   * @param headingGain yaw rate per heading error [1/s]
   * @param steeringLengthM wheel base over the nose wheel's full angle [m/rad]
   * @param damping rudder per yaw rate error at 10 m/s, nose wheel down [s/rad]
   * @param integral rudder per integrated yaw rate error at 10 m/s [1/rad]
   * @param airDamping rudder per yaw rate error, nose wheel up [s/rad]
   * @param airIntegral rudder per integrated yaw rate error, nose wheel up [1/rad]
   * @param weathercock rudder against the wind's push on the fin, per sideslip, nose wheel up
   *     [1/rad]
   * @param intoWind aileron per metre per second of crosswind when standing, less with speed [s/m]
   */
  record Parameters(
      double lookAheadS,
      double shortestM,
      double headingGain,
      double steeringLengthM,
      double damping,
      double integral,
      double airDamping,
      double airIntegral,
      double weathercock,
      double intoWind) {}

  private static final double SLOWEST_MPS = 4.0; // slower, the wheel's geometry would ask too much
  private static final double GENTLE_MPS2 = 55.0; // sideways, per radian of heading error
  private static final double GENTLE_SHARE = 0.3; // of the heading's pace, for the offset
  private static final double VANE_SHARE = 0.4; // the tyres hold the rest
  private static final double VANE_RAD = 0.4; // more is slow, and for the nose wheel to hold
  private static final double CLOSING_MPS = 2.0; // most speed across the line, back to it
  private static final double REFERENCE_MPS = 10.0;
  private static final double AILERON_WORKS_MPS = 40.0; // aileron needed falls to nothing here

  private final Parameters parameters;
  private double northM;
  private double eastM;
  private double headingRad;
  private double integral;
  private boolean lined;

  GroundSteering(Parameters parameters) {
    this.parameters = parameters;
  }

  /** Lays the centreline through the aircraft, along its heading. */
  void lineUp(FlightState state) {
    northM = state.northM();
    eastM = state.eastM();
    headingRad = state.headingRad();
    integral = 0.0;
    lined = true;
  }

  /** Lays the centreline through the aircraft, along its way over ground. */
  void lineUpAlongTrack(FlightState state) {
    lineUp(state);
    headingRad = StrictMath.atan2(state.eastMps(), state.northMps());
  }

  /** Lays the centreline through a point, along a course. */
  void lineUpAlong(double throughNorthM, double throughEastM, double courseRad) {
    northM = throughNorthM;
    eastM = throughEastM;
    headingRad = courseRad;
    integral = 0.0;
    lined = true;
  }

  /** Goes on from a rudder that something else has found. */
  void holds(double rudder) {
    integral = rudder;
  }

  void handOver(HandOver state) {
    if (lined) {
      state
          .number("CENTRELINE NORTH", northM)
          .number("CENTRELINE EAST", eastM)
          .number("CENTRELINE HEADING", headingRad)
          .number("STEERING INTEGRAL", integral);
    }
  }

  void takeOver(HandOver state) {
    lined = state.number("CENTRELINE HEADING").isPresent();
    northM = state.number("CENTRELINE NORTH").orElse(0.0);
    eastM = state.number("CENTRELINE EAST").orElse(0.0);
    headingRad = state.number("CENTRELINE HEADING").orElse(0.0);
    integral = state.number("STEERING INTEGRAL").orElse(0.0);
  }

  boolean lined() {
    return lined;
  }

  double headingRad() {
    return headingRad;
  }

  /** Distance from the centreline, right positive [m]. */
  double offsetM(FlightState state) {
    double north = state.northM() - northM;
    double east = state.eastM() - eastM;
    return east * StrictMath.cos(headingRad) - north * StrictMath.sin(headingRad);
  }

  /** A point ahead on the extended centreline: north [m] from the aircraft. */
  double aheadNorthM(FlightState state, double distanceM) {
    double offset = offsetM(state);
    return distanceM * StrictMath.cos(headingRad) + offset * StrictMath.sin(headingRad);
  }

  /** A point ahead on the extended centreline: east [m] from the aircraft. */
  double aheadEastM(FlightState state, double distanceM) {
    double offset = offsetM(state);
    return distanceM * StrictMath.sin(headingRad) - offset * StrictMath.cos(headingRad);
  }

  /**
   * Rudder, −1…1, positive turns right.
   *
   * @param noseDown whether the nose wheel steers
   */
  double rudder(FlightState state, boolean noseDown, double dtS) {
    double ground = state.groundSpeedMps();
    double look = Math.max(parameters.shortestM(), parameters.lookAheadS() * ground);
    double wanted = headingRad - StrictMath.atan2(offsetM(state), look);
    double rate = parameters.headingGain() * Limit.angle(wanted - state.headingRad());
    double vane = noseDown ? 0.0 : -parameters.weathercock() * state.betaRad();
    return rudder(state, rate, noseDown, vane, dtS);
  }

  /**
   * Rudder of a roll-out, −1…1, positive turns right: the faster it rolls the more gently it turns
   * back to the line, as it comes from the air with some way sideways and light on its wheels.
   *
   * @param noseDown whether the nose wheel steers
   */
  double gentleRudder(FlightState state, boolean noseDown, double dtS) {
    double speed = Math.max(SLOWEST_MPS, state.groundSpeedMps());
    double gain = Math.min(parameters.headingGain(), GENTLE_MPS2 / speed);
    double closing = Limit.symmetric(-offsetM(state) * gain * GENTLE_SHARE, CLOSING_MPS);
    double wanted = headingRad + StrictMath.atan2(closing, speed);
    double rate = gain * Limit.angle(wanted - state.headingRad());
    double vane =
        -parameters.weathercock() * Limit.symmetric(state.betaRad(), VANE_RAD) * VANE_SHARE;
    return rudder(state, rate, noseDown, vane, dtS);
  }

  private double rudder(FlightState state, double rate, boolean noseDown, double vane, double dtS) {
    double ground = state.groundSpeedMps();
    double speed = Math.max(SLOWEST_MPS, ground);
    double error = rate - state.yawRate();
    double perSpeed = REFERENCE_MPS / speed;
    double damping = noseDown ? parameters.damping() * perSpeed : parameters.airDamping();
    double gain = noseDown ? parameters.integral() * perSpeed : parameters.airIntegral();
    double direct = rate * parameters.steeringLengthM() / speed + damping * error + vane;
    double next = integral + gain * error * dtS;
    double raw = direct + next;
    boolean deeper = (raw > 1.0 && error > 0.0) || (raw < -1.0 && error < 0.0);
    boolean rolling = ground > 1.0;
    if (!deeper && rolling) {
      integral = Limit.symmetric(next, 1.0);
    }
    return Limit.symmetric(direct + integral, 1.0);
  }

  /** Rudder in the air that turns the nose along the line, −1…1, positive turns right. */
  double align(FlightState state, double dtS) {
    double rate = parameters.headingGain() * Limit.angle(headingRad - state.headingRad());
    double error = rate - state.yawRate();
    double next = integral + parameters.airIntegral() * error * dtS;
    double direct = parameters.airDamping() * error;
    if (Math.abs(direct + next) < 1.0 || error * next < 0.0) {
      integral = Limit.symmetric(next, 1.0);
    }
    return Limit.symmetric(direct + integral, 1.0);
  }

  /** Aileron into the wind, −1…1: much when slow, less as the ailerons gain effect. */
  double aileron(FlightState state) {
    double share = Limit.within(0.0, 1.0 - state.calibratedAirspeedMps() / AILERON_WORKS_MPS, 1.0);
    return Limit.symmetric(parameters.intoWind() * state.crosswindMps() * share, 1.0);
  }
}
