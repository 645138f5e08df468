package org.u2sa.device.port;

/** An anemometer with a vane, or an ultrasonic one: measures the apparent wind. */
public interface Anemometer extends Device<Anemometer.Wind> {
  /**
   * The apparent wind: the air's motion relative to the vehicle.
   *
   * @param speedMps its speed [m/s], not negative
   * @param fromRad direction from which it blows, relative to the instrument's zero, positive to
   *     the left [rad], −π…π
   */
  record Wind(long measuredAtMicros, double speedMps, double fromRad) implements Reading {}
}
