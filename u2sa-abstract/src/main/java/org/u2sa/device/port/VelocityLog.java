package org.u2sa.device.port;

import java.util.OptionalDouble;
import java.util.stream.Stream;

/** A Doppler velocity log, or a simpler log that measures some of these speeds. */
public interface VelocityLog extends Device<VelocityLog.Speeds> {
  /**
   * The vehicle's speeds along its own axes, x forward, y left, z down. Unmeasured and invalid
   * values are empty.
   *
   * @param groundX speed over ground, forward [m/s]
   * @param groundY speed over ground, left [m/s]
   * @param groundZ speed over ground, down [m/s]
   * @param waterX speed through water, forward [m/s]
   * @param waterY speed through water, left [m/s]
   * @param waterZ speed through water, down [m/s]
   */
  record Speeds(
      long measuredAtMicros,
      OptionalDouble groundX,
      OptionalDouble groundY,
      OptionalDouble groundZ,
      OptionalDouble waterX,
      OptionalDouble waterY,
      OptionalDouble waterZ)
      implements Reading {
    /** Whether any value is present. */
    public boolean isAny() {
      return Stream.of(groundX, groundY, groundZ, waterX, waterY, waterZ)
          .anyMatch(OptionalDouble::isPresent);
    }
  }
}
