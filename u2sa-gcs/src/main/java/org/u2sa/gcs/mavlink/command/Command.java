package org.u2sa.gcs.mavlink.command;

import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import java.util.Optional;
import java.util.Set;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.messages.frame.Geodetic;

/**
 * A command in either of its two forms.
 *
 * @param id MAV_CMD
 * @param frame MAV_FRAME; COMMAND_LONG has none, so the one that the presented autopilot assumes
 * @param latitude fifth parameter, in degrees for COMMAND_INT; NaN: none
 * @param longitude sixth parameter
 * @param altitude seventh parameter
 */
record Command(
    int id,
    int frame,
    float param1,
    float param2,
    float param3,
    float param4,
    double latitude,
    double longitude,
    double altitude) {
  private static final double PER_DEGREE = 1.0e7;
  private static final int GLOBAL = 0; // MAV_FRAME_GLOBAL…
  private static final int RELATIVE = 3;
  private static final int GLOBAL_INT = 5;
  private static final int RELATIVE_INT = 6;
  private static final double MAX_LATITUDE = 90.0;
  private static final double MAX_LONGITUDE = 180.0;

  static Command of(CommandLong message, Identity identity) {
    return new Command(
        message.command().value(),
        identity.commandsAboveHome() ? RELATIVE : GLOBAL,
        message.param1(),
        message.param2(),
        message.param3(),
        message.param4(),
        message.param5(),
        message.param6(),
        message.param7());
  }

  static Command of(CommandInt message) {
    return new Command(
        message.command().value(),
        message.frame().value(),
        message.param1(),
        message.param2(),
        message.param3(),
        message.param4(),
        degrees(message.x()),
        degrees(message.y()),
        message.z());
  }

  private static double degrees(int wire) {
    return wire == Integer.MAX_VALUE ? Double.NaN : wire / PER_DEGREE; // stands for NaN
  }

  /** Reason why its position cannot be used, such as an unsupported frame; empty if it can. */
  Optional<String> frameRefusal(Optional<Geodetic> home) {
    if (!Set.of(GLOBAL, RELATIVE, GLOBAL_INT, RELATIVE_INT).contains(frame)) {
      return Optional.of("MAV_FRAME " + frame + "; expected one above sea level or above home");
    }
    return isAboveHome() && Double.isFinite(altitude) && home.isEmpty()
        ? Optional.of("the altitude is above home, which is not known yet")
        : Optional.empty();
  }

  private boolean isAboveHome() {
    return frame == RELATIVE || frame == RELATIVE_INT;
  }

  /** Altitude above mean sea level [m]; empty if none is given. */
  Optional<Double> altitudeM(Optional<Geodetic> home) {
    if (!Double.isFinite(altitude)) {
      return Optional.empty();
    }
    return Optional.of(isAboveHome() ? altitude + home.orElseThrow().altitudeM() : altitude);
  }

  /** Whether it names a place; 0/0 means none. */
  boolean hasPlace() {
    return Double.isFinite(latitude)
        && Double.isFinite(longitude)
        && (latitude != 0.0 || longitude != 0.0)
        && Math.abs(latitude) <= MAX_LATITUDE
        && Math.abs(longitude) <= MAX_LONGITUDE;
  }
}
