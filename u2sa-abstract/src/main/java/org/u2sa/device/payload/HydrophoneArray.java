package org.u2sa.device.payload;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.device.port.Device;

/**
 * An array of hydrophones with its processor, which measures either the direction of a ping or its
 * arrival times at the hydrophones.
 */
public interface HydrophoneArray extends Device<HydrophoneArray.Heard> {
  /** One ping, in one of the two forms. */
  interface Heard extends Reading {
    /** Frequency of the ping [Hz]. */
    double frequencyHz();
  }

  /**
   * Direction of one ping.
   *
   * @param frequencyHz its frequency [Hz]
   * @param azimuthRad direction of the source, relative to the array's zero, positive to the left
   *     [rad], −π…π
   * @param elevationRad above the array's plane, up positive [rad], −π/2…π/2
   * @param sigmaRad standard deviation of either angle [rad]; empty if the array reports none
   */
  record Ping(
      long measuredAtMicros,
      double frequencyHz,
      double azimuthRad,
      double elevationRad,
      OptionalDouble sigmaRad)
      implements Heard {}

  /**
   * Arrival times of one ping.
   *
   * @param frequencyHz its frequency [Hz]
   * @param arrivalsS arrival at each hydrophone after any common instant [s], in the order of the
   *     array
   */
  record Arrivals(long measuredAtMicros, double frequencyHz, List<Double> arrivalsS)
      implements Heard {}
}
