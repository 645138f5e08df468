package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * Holds the runway centreline by rudder and nose wheel: aims at a point ahead on the line, turns at
 * a rate proportional to the heading error, and computes the rudder from the geometry of a steered
 * wheel, ψ̇ = V/L · δ, whose effect grows with speed. The proportional gain on the rate is likewise
 * divided by speed; the integral compensates propeller effects and crosswind.
 */
final class GroundSteering {
  /** Gains on the runway. */
  record Variables(
      @Variable(unit = "s", min = 0.5, max = 10, ifAbsent = 2.5)
          @Description("Look-ahead time to the aim point on the runway centreline.")
          double centrelineLookAheadTime,
      @Variable(unit = "m", min = 5, max = 200, ifAbsent = 40)
          @Description("Minimum distance to the aim point on the runway centreline.")
          double centrelineLookAhead,
      @Variable(unit = "1/s", min = 0.1, max = 5, ifAbsent = 1.8)
          @Description("Yaw rate per heading error on the runway.")
          double centrelineHeadingGain,
      @Variable(unit = "m/rad", min = 1, max = 50, ifAbsent = 9.5)
          @Description("Wheelbase over the nose-wheel angle at full rudder.")
          double steeringLength,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 1.6)
          @Description("Rudder per yaw-rate error at 10 m/s, nose wheel down.")
          double steeringDamping,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 1.2)
          @Description("Rudder per integrated yaw-rate error at 10 m/s, nose wheel down.")
          double steeringIntegralGain,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 1.5)
          @Description("Rudder per yaw-rate error, nose wheel up.")
          double rotationYawDamping,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 1.5)
          @Description("Rudder per integrated yaw-rate error, nose wheel up.")
          double rotationYawIntegralGain,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 1.2)
          @Description("Rudder per sideslip, nose wheel up, against weathercocking.")
          double weathercockGain,
      @Variable(unit = "s/m", min = 0, max = 1, ifAbsent = 0.1)
          @Description("Aileron per crosswind at standstill; decreases with speed.")
          double aileronIntoWind) {}

  private static final double SLOWEST_MPS = 4.0; // at lower speeds, geometry would demand too much
  private static final double GENTLE_MPS2 = 55.0; // lateral, per radian of heading error
  private static final double GENTLE_SHARE = 0.3; // fraction of the heading bandwidth
  private static final double VANE_SHARE = 0.4; // the tyres resist the rest
  private static final double VANE_RAD =
      0.4; // beyond this angle the aircraft is slow, and the nose wheel grips
  private static final double CLOSING_MPS = 2.0; // maximum closing speed toward the line
  private static final double REFERENCE_MPS = 10.0;
  private static final double AILERON_WORKS_MPS = 40.0; // no aileron is needed from here on

  private final Variables parameters;
  private double northM;
  private double eastM;
  private double headingRad;
  private double integral;
  private boolean lined;

  GroundSteering(Variables parameters) {
    this.parameters = parameters;
  }

  /** Sets the centreline through the aircraft, along its heading. */
  void lineUp(FlightState state) {
    lineUpAlong(state.northM(), state.eastM(), state.headingRad());
  }

  /** Sets the centreline through the aircraft, along its track. */
  void lineUpAlongTrack(FlightState state) {
    double courseRad = StrictMath.atan2(state.eastMps(), state.northMps());
    lineUpAlong(state.northM(), state.eastM(), courseRad);
  }

  /** Sets the centreline through a point, along a course. */
  void lineUpAlong(double throughNorthM, double throughEastM, double courseRad) {
    northM = throughNorthM;
    eastM = throughEastM;
    headingRad = courseRad;
    integral = 0.0;
    lined = true;
  }

  /** Continues from the rudder of another law. */
  void holds(double rudder) {
    integral = rudder;
  }

  void transfer(Transfer state) {
    lined = state.has("CENTRELINE HEADING", lined);
    if (lined) {
      northM = state.number("CENTRELINE NORTH", northM);
      eastM = state.number("CENTRELINE EAST", eastM);
      headingRad = state.number("CENTRELINE HEADING", headingRad);
      integral = state.number("STEERING INTEGRAL", integral);
    }
  }

  /** Whether a centreline is set. */
  boolean lined() {
    return lined;
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
    double look =
        Math.max(parameters.centrelineLookAhead(), parameters.centrelineLookAheadTime() * ground);
    double wanted = headingRad - StrictMath.atan2(offsetM(state), look);
    double rate = parameters.centrelineHeadingGain() * Limit.angle(wanted - state.headingRad());
    double vane = noseDown ? 0.0 : -parameters.weathercockGain() * state.betaRad();
    return rudder(state, rate, noseDown, vane, dtS);
  }

  /**
   * Rudder of a roll-out, −1…1, positive turns right: gentler at higher speed, because the aircraft
   * touches down with some drift and little load on its wheels.
   *
   * @param noseDown whether the nose wheel steers
   */
  double gentleRudder(FlightState state, boolean noseDown, double dtS) {
    double speed = Math.max(SLOWEST_MPS, state.groundSpeedMps());
    double gain = Math.min(parameters.centrelineHeadingGain(), GENTLE_MPS2 / speed);
    double closing = Limit.symmetric(-offsetM(state) * gain * GENTLE_SHARE, CLOSING_MPS);
    double wanted = headingRad + StrictMath.atan2(closing, speed);
    double rate = gain * Limit.angle(wanted - state.headingRad());
    double vane =
        -parameters.weathercockGain() * Limit.symmetric(state.betaRad(), VANE_RAD) * VANE_SHARE;
    return rudder(state, rate, noseDown, vane, dtS);
  }

  private double rudder(FlightState state, double rate, boolean noseDown, double vane, double dtS) {
    double ground = state.groundSpeedMps();
    double speed = Math.max(SLOWEST_MPS, ground);
    double error = rate - state.yawRate();
    double perSpeed = REFERENCE_MPS / speed;
    double damping =
        noseDown ? parameters.steeringDamping() * perSpeed : parameters.rotationYawDamping();
    double gain =
        noseDown
            ? parameters.steeringIntegralGain() * perSpeed
            : parameters.rotationYawIntegralGain();
    double direct = rate * parameters.steeringLength() / speed + damping * error + vane;
    double next = next(gain, error, dtS);
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
    double rate = parameters.centrelineHeadingGain() * Limit.angle(headingRad - state.headingRad());
    double error = rate - state.yawRate();
    double next = next(parameters.rotationYawIntegralGain(), error, dtS);
    double direct = parameters.rotationYawDamping() * error;
    if (Math.abs(direct + next) < 1.0 || error * next < 0.0) {
      integral = Limit.symmetric(next, 1.0);
    }
    return Limit.symmetric(direct + integral, 1.0);
  }

  /** Integral after a step; 0 without a gain. */
  private double next(double gain, double error, double dtS) {
    integral = gain > 0.0 ? integral : 0.0;
    return integral + gain * error * dtS;
  }

  /** Aileron into the wind, −1…1: large at low speed, less as the ailerons become effective. */
  double aileron(FlightState state) {
    double share = Limit.within(0.0, 1.0 - state.calibratedAirspeedMps() / AILERON_WORKS_MPS, 1.0);
    return Limit.symmetric(parameters.aileronIntoWind() * state.crosswindMps() * share, 1.0);
  }
}
