package org.u2sa.drivers.gps;

import org.u2sa.device.GpsFix;

/**
 * What receivers mean by their horizontal accuracy, taken to the standard deviation of each axis
 * that {@link GpsFix} and State Information have.
 *
 * <p>u-blox's hAcc (NAV-PVT, NAV-POSLLH) and MAVLink's h_acc (GPS_RAW_INT, into which ArduPilot and
 * PX4 copy hAcc) are the root mean square of the horizontal distance, √(σE² + σN²): measured
 * against GST's axes and confirmed in u-blox's forum, question 24428; the receiver descriptions
 * only say "horizontal accuracy estimate". NMEA's GST says the axes' own already. Android's
 * accuracy is another radius, that of 68 % of the fixes, and is converted where the phone is read.
 */
public final class HorizontalError {
  private HorizontalError() {}

  /**
   * Standard deviation along each horizontal axis [m].
   *
   * @param distanceRmsM root mean square of the horizontal distance [m]
   */
  public static double perAxisM(double distanceRmsM) {
    return distanceRmsM / Math.sqrt(2.0); // √(σ² + σ²) = √2 σ
  }
}
