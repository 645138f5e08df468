package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsRawInt;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.drivers.gps.HorizontalError;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * State Information in GLOBAL from the autopilot: one per ATTITUDE and one per GLOBAL_POSITION_INT,
 * with accuracies from GPS_RAW_INT. Each value is published once, with its arrival time
 * (mavlink.io/en/messages/common.html).
 */
final class AutopilotState {
  private static final double DEGREES = 1.0e-7;
  private static final double MILLI = 1.0e-3;
  private static final double CENTI = 1.0e-2;
  private static final double FULL_TURN = 2.0 * Math.PI;
  private static final double NEARLY_VERTICAL = Math.toRadians(89.0);
  private static final int FIX_3D = 3;
  private static final double MAX_LATITUDE = 90.0;
  private static final double MAX_LONGITUDE = 180.0;
  private static final double MAX_RATE = 100.0; // rad/s: beyond any autopilot's gyroscopes

  private final long staleMicros;
  private GpsRawInt gps;
  private long gpsMicros;

  /**
   * @param staleAfterS age at which a position counts as absent [s]
   */
  AutopilotState(double staleAfterS) {
    staleMicros = Clock.micros(staleAfterS);
  }

  /** Resets, for another autopilot or after a loss. */
  void reset() {
    gps = null;
  }

  void accept(GpsRawInt message, long nowMicros) {
    gps = message;
    gpsMicros = nowMicros;
  }

  /**
   * State from an attitude.
   *
   * @throws IllegalArgumentException if an angle or rate is not a number or is implausible
   */
  StateInformation attitude(Attitude attitude, long nowMicros) {
    within("roll", attitude.roll(), FULL_TURN, "rad"); // defined as ±π; yaw also comes as 0…2π
    within("pitch", attitude.pitch(), FULL_TURN, "rad");
    within("yaw", attitude.yaw(), FULL_TURN, "rad");
    within("rollspeed", attitude.rollspeed(), MAX_RATE, "rad/s");
    within("pitchspeed", attitude.pitchspeed(), MAX_RATE, "rad/s");
    within("yawspeed", attitude.yawspeed(), MAX_RATE, "rad/s");
    double psi = attitude.yaw() % FULL_TURN;
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .phi(attitude.roll())
            .theta(attitude.pitch())
            .psi(psi < 0.0 ? psi + FULL_TURN : psi);
    state.timestamp(nowMicros);
    if (Math.abs(attitude.pitch()) < NEARLY_VERTICAL) {
      rates(attitude, state);
    }
    return state;
  }

  private static void within(String what, double value, double most, String unit) {
    if (!(Math.abs(value) <= most)) {
      throw new IllegalArgumentException(
          String.format(Locale.ROOT, "%s %.3f is outside ±%s %s", what, value, most, unit));
    }
  }

  /**
   * State from a position; empty without a fix.
   *
   * @throws IllegalArgumentException if it is not on Earth
   */
  Optional<StateInformation> position(GlobalPositionInt position, long nowMicros) {
    double latitude = position.lat() * DEGREES;
    double longitude = position.lon() * DEGREES;
    within("latitude", latitude, MAX_LATITUDE, "deg");
    within("longitude", longitude, MAX_LONGITUDE, "deg");
    boolean hasGps = gps != null && nowMicros - gpsMicros <= staleMicros;
    boolean isUnknown =
        position.lat() == 0 && position.lon() == 0; // sent before the position is known
    if (isUnknown || hasGps && gps.fixType().value() < FIX_3D) {
      return Optional.empty();
    }
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(longitude)
            .y(latitude)
            .z(position.alt() * MILLI)
            .xDot(position.vy() * CENTI) // MAVLink: north, east, down
            .yDot(position.vx() * CENTI)
            .zDot(-position.vz() * CENTI);
    state.timestamp(nowMicros);
    if (hasGps) {
      errors(state);
    }
    return Optional.of(state);
  }

  /** Converts MAVLink's body rates to Euler angle rates. */
  private static void rates(Attitude attitude, StateInformation state) {
    Point euler =
        new org.u2sa.messages.frame.Attitude(attitude.roll(), attitude.pitch(), attitude.yaw())
            .eulerRates(Point.of(attitude.rollspeed(), attitude.pitchspeed(), attitude.yawspeed()));
    state.phiDot(euler.x()).thetaDot(euler.y()).psiDot(euler.z());
  }

  private void errors(StateInformation state) {
    if (gps.hAcc() > 0) { // 0: unknown
      double sigma = HorizontalError.perAxisM(gps.hAcc() * MILLI);
      state.xSigma(sigma).ySigma(sigma);
    }
    if (gps.vAcc() > 0) {
      state.zSigma(gps.vAcc() * MILLI);
    }
    if (gps.velAcc() > 0) {
      double sigma = gps.velAcc() * MILLI; // of the total velocity: an upper bound per axis
      state.xDotSigma(sigma).yDotSigma(sigma).zDotSigma(sigma);
    }
  }
}
