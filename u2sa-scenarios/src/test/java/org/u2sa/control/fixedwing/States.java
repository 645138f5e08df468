package org.u2sa.control.fixedwing;

/** Flight states for tests: level flight to the east, changed one value at a time. */
final class States {
  private double timeS;
  private double northM;
  private double eastM;
  private double altitudeM = 300.0;
  private double heightM = 295.0;
  private double rollRad;
  private double pitchRad = 0.05;
  private double headingRad = Math.PI / 2.0;
  private double rollRate;
  private double pitchRate;
  private double yawRate;
  private double northMps;
  private double eastMps = 43.0;
  private double climbMps;
  private double trueAirspeedMps = 43.0;
  private double calibratedAirspeedMps = 43.0;
  private double alphaRad = 0.05;
  private double betaRad;
  private boolean onGround;
  private double engineRpm = 2300.0;
  private boolean engineStarting;
  private boolean wheelsSensed = true;
  private boolean overGroundKnown = true;

  /** 43 m/s towards east, 300 m up. */
  static States level() {
    return new States();
  }

  /** On its wheels, engine idling, heading east. */
  static States standing() {
    States states = new States().height(0.0).speed(0.0).rpm(700.0).pitch(0.05).onGround(true);
    states.altitudeM = 5.0;
    return states;
  }

  States time(double seconds) {
    timeS = seconds;
    return this;
  }

  States at(double north, double east) {
    northM = north;
    eastM = east;
    return this;
  }

  States altitude(double metres) {
    altitudeM = metres;
    return this;
  }

  States height(double metres) {
    heightM = metres;
    return this;
  }

  States roll(double rad) {
    rollRad = rad;
    return this;
  }

  States pitch(double rad) {
    pitchRad = rad;
    return this;
  }

  States heading(double rad) {
    headingRad = rad;
    return this;
  }

  States rates(double p, double q, double r) {
    rollRate = p;
    pitchRate = q;
    yawRate = r;
    return this;
  }

  /** Over ground, east and north; the airspeed stays. */
  States ground(double north, double east) {
    northMps = north;
    eastMps = east;
    return this;
  }

  /** Through still air, to the east. */
  States speed(double mps) {
    trueAirspeedMps = mps;
    calibratedAirspeedMps = mps;
    northMps = 0.0;
    eastMps = mps;
    return this;
  }

  States climb(double mps) {
    climbMps = mps;
    return this;
  }

  States alpha(double rad) {
    alphaRad = rad;
    return this;
  }

  States beta(double rad) {
    betaRad = rad;
    return this;
  }

  States onGround(boolean value) {
    onGround = value;
    return this;
  }

  States rpm(double perMinute) {
    engineRpm = perMinute;
    return this;
  }

  States starting(boolean value) {
    engineStarting = value;
    return this;
  }

  States wheelsSensed(boolean value) {
    wheelsSensed = value;
    return this;
  }

  States overGroundKnown(boolean value) {
    overGroundKnown = value;
    return this;
  }

  FlightState now() {
    return new FlightState(
        timeS,
        northM,
        eastM,
        altitudeM,
        heightM,
        rollRad,
        pitchRad,
        headingRad,
        rollRate,
        pitchRate,
        yawRate,
        northMps,
        eastMps,
        climbMps,
        trueAirspeedMps,
        calibratedAirspeedMps,
        alphaRad,
        betaRad,
        onGround,
        engineRpm,
        engineStarting,
        wheelsSensed,
        overGroundKnown);
  }
}
