package org.u2sa.drivers.gps;

import org.u2sa.device.port.GpsFix;

/**
 * Converts receivers' horizontal accuracy to the per-axis standard deviation used by {@link GpsFix}
 * and State Information.
 *
 * <p>u-blox's hAcc (NAV-PVT, NAV-POSLLH) and MAVLink's h_acc (GPS_RAW_INT, into which ArduPilot and
 * PX4 copy hAcc) are the root mean square of the horizontal distance, √(σE² + σN²): measured
 * against GST and confirmed in u-blox's forum, question 24428; the receiver descriptions only say
 * "horizontal accuracy estimate". NMEA's GST is already per axis. Android's accuracy is the 68 %
 * radius and is converted when the phone is read.
 */
public final class HorizontalError {
  private HorizontalError() {}

  /**
   * Standard deviation per horizontal axis [m].
   *
   * @param distanceRmsM RMS horizontal distance error [m]
   */
  public static double perAxisM(double distanceRmsM) {
    return distanceRmsM / Math.sqrt(2.0); // √(σ² + σ²) = √2 σ
  }
}
