package org.u2sa.scenarios.suas;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.device.port.Servo;
import org.u2sa.device.port.Thruster;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * A pilot with a radio who takes over for a while, keeps the wings level, holds height, and turns
 * away from the boundary. Meanwhile the multiplexer connects the sticks to servos and motor,
 * whatever the vehicle's services command.
 */
final class SuasPilot {
  private static final double MANUAL_S = 0.001; // pulses of the switch
  private static final double AUTOMATIC_S = 0.002;
  private static final int SWITCH = 5;
  private static final double AHEAD_S = 10.0; // look-ahead to the boundary
  private static final double TURN_RAD = Math.toRadians(35.0);
  private static final double ROLL_GAIN = 0.8; // stick per radian
  private static final double ROLL_DAMPING = 0.12; // stick per rad/s
  private static final double PITCH_GAIN = 1.2;
  private static final double PITCH_DAMPING = 0.2;
  private static final double CLIMB_GAIN = 0.04; // rad of pitch per m/s
  private static final double HEIGHT_GAIN = 0.2; // m/s per m
  private static final double TRIM = 0.25; // elevator trim, up
  private static final double THROTTLE = 0.7;
  private static final double FULL_RAD = Math.PI / 6.0; // stick travel
  private static final double FULL_PERCENT = 100.0;

  private final SuasField field;
  private final RunningVehicle run;
  private final double fromS;
  private final double untilS;
  private double heightM = Double.NaN; // height at the takeover

  /**
   * @param fromS time of the takeover [s]; infinite for never
   * @param untilS time of giving back control [s]
   */
  SuasPilot(SuasField field, RunningVehicle run, double fromS, double untilS) {
    this.field = field;
    this.run = run;
    this.fromS = fromS;
    this.untilS = untilS;
  }

  private boolean flies(VehicleTruth truth) {
    boolean flies = truth.timeS() >= fromS && truth.timeS() < untilS;
    heightM = !flies ? Double.NaN : Double.isNaN(heightM) ? truth.position().z() : heightM;
    return flies;
  }

  /** The on-board receiver; only its switch is read. */
  RadioReceiver receiver() {
    return nowMicros -> {
      List<Double> widths = new ArrayList<>(Collections.nCopies(SWITCH, 0.0015));
      widths.set(SWITCH - 1, flies(run.at(nowMicros)) ? MANUAL_S : AUTOMATIC_S);
      return Optional.of(new RadioReceiver.Pulses(nowMicros, widths));
    };
  }

  /** A servo behind the multiplexer. */
  Servo servo(String actuator, Servo own) {
    return new Servo() {
      private double wanted;

      @Override
      public Optional<Position> read(long nowMicros) {
        VehicleTruth truth = run.at(nowMicros);
        own.turn(flies(truth) ? FULL_RAD * stick(actuator, truth) : wanted);
        return own.read(nowMicros);
      }

      @Override
      public void turn(double angleRad) {
        wanted = angleRad;
      }

      @Override
      public void leave() {
        own.leave();
      }

      @Override
      public void close() {
        own.close();
      }
    };
  }

  /** The motor behind the multiplexer. */
  Thruster motor(Thruster own) {
    return new Thruster() {
      private double wanted;

      @Override
      public Optional<Turning> read(long nowMicros) {
        own.thrust(flies(run.at(nowMicros)) ? FULL_PERCENT * THROTTLE : wanted);
        return own.read(nowMicros);
      }

      @Override
      public void thrust(double percent) {
        wanted = percent;
      }

      @Override
      public void stop(long nowMicros) {
        wanted = 0.0;
        own.stop(nowMicros);
      }

      @Override
      public void leave() {
        own.leave();
      }

      @Override
      public void close() {
        own.close();
      }
    };
  }

  /** Deflection of an actuator's stick, −1…1, with the sign of its commands. */
  private double stick(String actuator, VehicleTruth truth) {
    return switch (actuator) {
      case "AILERON" ->
          ROLL_GAIN * (bankRad(truth) - truth.attitude().phi()) - ROLL_DAMPING * truth.rates().x();
      case "ELEVATOR" -> elevator(truth);
      default -> 0.0;
    };
  }

  private double elevator(VehicleTruth truth) {
    double climbMps = HEIGHT_GAIN * (heightM - truth.position().z());
    double pitch = CLIMB_GAIN * (climbMps - truth.velocity().z());
    double wanted = Math.max(-0.25, Math.min(0.25, pitch));
    double up =
        TRIM + PITCH_GAIN * (wanted - truth.attitude().theta()) - PITCH_DAMPING * truth.rates().y();
    return -Math.max(-1.0, Math.min(1.0, up));
  }

  private double bankRad(VehicleTruth truth) {
    Point ahead = truth.position().plus(truth.velocity().times(AHEAD_S));
    return SuasField.isInside(field.boundary(), ahead.x(), ahead.y()) ? 0.0 : TURN_RAD;
  }
}
