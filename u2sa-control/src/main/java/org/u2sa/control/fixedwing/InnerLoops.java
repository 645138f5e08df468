package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;

/**
 * The inner loops and their setpoints: bank by the ailerons, pitch by the elevator, coordination by
 * the rudder; and the current rudder and throttle.
 */
final class InnerLoops {
  private static final double MIN_SCALE = 0.6;
  private static final double MAX_SCALE = 1.6;
  private static final double RUDDER_RATE = 2.0; // 1/s: from stop to stop in half a second

  private final AutopilotVariables tuning;
  private final RollLaw roll;
  private final PitchLaw pitch;
  private final YawLaw yaw;
  private double bankRad;
  private double pitchRad;
  private double rudder;
  private double throttle;

  InnerLoops(AutopilotVariables tuning) {
    this.tuning = tuning;
    roll = new RollLaw(tuning.roll());
    pitch = new PitchLaw(tuning.pitch());
    yaw = new YawLaw(tuning.yaw());
  }

  /** Scale of surface gains, which hold at one speed: effectiveness changes with speed. */
  private double scale(FlightState state) {
    double speed = Math.max(1.0, state.calibratedAirspeedMps());
    return Limit.within(MIN_SCALE, tuning.guidance().referenceSpeed() / speed, MAX_SCALE);
  }

  /** Bank set point [rad]. */
  double bankRad() {
    return bankRad;
  }

  /** Sets the bank set point without rate limit [rad]. */
  void hold(double newBankRad) {
    bankRad = newBankRad;
  }

  /** Moves the bank set point toward another [rad] at the tuned rate. */
  void bankTowards(double wantedRad, double dtS) {
    bankRad =
        Limit.approach(bankRad, wantedRad, Math.toRadians(tuning.guidance().bankRateLimit()) * dtS);
  }

  /** Pitch set point [rad]. */
  double pitchRad() {
    return pitchRad;
  }

  /** Sets the pitch set point [rad]. */
  void pitch(double newPitchRad) {
    pitchRad = newPitchRad;
  }

  /** Throttle, 0…1. */
  double throttle() {
    return throttle;
  }

  void throttle(double newThrottle) {
    throttle = newThrottle;
  }

  /** Moves the throttle at a limited rate. */
  void throttleTowards(double wanted, double dtS) {
    throttle = Limit.approach(throttle, wanted, tuning.climbOut().throttleOpeningRate() * dtS);
  }

  /** Rudder, −1…1, positive yaws right. */
  double rudder() {
    return rudder;
  }

  void rudder(double newRudder) {
    rudder = newRudder;
  }

  /** Aileron that holds the bank, −1…1, positive rolls right. */
  double aileron(FlightState state, double dtS) {
    return roll.aileron(state, bankRad, scale(state), dtS);
  }

  /** Aileron that holds the wings level, whatever the bank set point. */
  double levelAileron(FlightState state, double dtS) {
    return roll.aileron(state, 0.0, scale(state), dtS);
  }

  /** Elevator that holds the pitch, −1…1, positive lowers the nose. */
  double elevator(FlightState state, double dtS) {
    return pitch.elevator(state, pitchRad, scale(state), dtS);
  }

  /** Moves the rudder so that the turn is coordinated. */
  void coordinate(FlightState state, double aileron, double dtS) {
    double wanted = yaw.rudder(state, aileron, scale(state), dtS);
    rudder = Limit.approach(rudder, wanted, RUDDER_RATE * dtS);
  }

  /** Resets the roll and pitch loops. */
  void restart() {
    pitch.restart(0.0);
    roll.restart(0.0);
  }

  /** Restarts the yaw loop at the current rudder. */
  void restartYaw() {
    yaw.restart(rudder);
  }

  /** Starts from another control law's commands, shares of full as in {@link Surfaces}. */
  void takeOver(double aileron, double elevator, double lastRudder, double lastThrottle) {
    roll.restart(aileron);
    pitch.restart(-elevator); // positive lowers the nose
    yaw.restart(lastRudder);
    rudder = lastRudder;
    throttle = lastThrottle;
  }

  void transfer(Transfer state) {
    throttle = state.number("THROTTLE", throttle);
    rudder = state.number("RUDDER", rudder);
    bankRad = state.number("BANK DEMAND", bankRad);
    pitchRad = state.number("PITCH DEMAND", pitchRad);
    roll.transfer(state);
    pitch.transfer(state);
    yaw.transfer(state);
  }
}
