package org.u2sa.device.payload;

import java.util.OptionalDouble;
import org.u2sa.device.port.Device;

/** An array of hydrophones with its processor: measures the direction of pings. */
public interface HydrophoneArray extends Device<HydrophoneArray.Ping> {
  /**
   * One ping.
   *
   * @param frequencyHz its frequency [Hz]
   * @param azimuthRad direction it comes from, from the array's own zero, to the left positive
   *     [rad], −π…π
   * @param elevationRad above the array's plane, up positive [rad], −π/2…π/2
   * @param sigmaRad standard deviation of either angle [rad]; empty if the array does not say
   */
  record Ping(
      long measuredAtMicros,
      double frequencyHz,
      double azimuthRad,
      double elevationRad,
      OptionalDouble sigmaRad)
      implements Reading {}
}
