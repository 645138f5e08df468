package org.u2sa.device;

import java.util.OptionalDouble;

/** A Doppler velocity log, or a simpler log that measures some of its speeds. */
public interface VelocityLog extends Device<VelocityLog.Speeds> {
  /**
   * The vehicle's speeds along its own axes, x forward, y left, z down. What is not measured, or
   * not valid now, is empty.
   *
   * @param groundX over the bottom, forward [m/s]
   * @param groundY over the bottom, to the left [m/s]
   * @param groundZ over the bottom, down [m/s]
   * @param waterX through the water, forward [m/s]
   * @param waterY through the water, to the left [m/s]
   * @param waterZ through the water, down [m/s]
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
    /** Whether anything is measured. */
    public boolean isAny() {
      return groundX.isPresent()
          || groundY.isPresent()
          || groundZ.isPresent()
          || waterX.isPresent()
          || waterY.isPresent()
          || waterZ.isPresent();
    }
  }
}
