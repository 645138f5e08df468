package org.u2sa.device.pressure;

import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;

/**
 * Constant error of a pressure sensor, from readings at a known pressure. It matters for depths: 1
 * kPa is 0.1 m, and a sensor for 300 m is accurate to about 5 kPa. Not thread-safe.
 */
public final class PressureZero {
  private OptionalDouble errorPa = OptionalDouble.empty();
  private long beganMicros = Long.MIN_VALUE;
  private double sumPa;
  private int count;

  /** The error [Pa]; empty until it is known. */
  public OptionalDouble errorPa() {
    return errorPa;
  }

  /** Fixes the error [Pa]. */
  public void is(double pascals) {
    errorPa = OptionalDouble.of(pascals);
  }

  /**
   * Processes a reading; the mean error applies once the time has passed.
   *
   * @param measuredMicros time of the reading [µs]
   * @param offPa reading minus the known pressure [Pa]
   * @param forS length of time [s]
   */
  public void take(long measuredMicros, double offPa, double forS) {
    beganMicros = count == 0 ? measuredMicros : beganMicros;
    sumPa += offPa;
    count++;
    if (measuredMicros - beganMicros >= Clock.micros(forS)) {
      is(sumPa / count);
    }
  }
}
