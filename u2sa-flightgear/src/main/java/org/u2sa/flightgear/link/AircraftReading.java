package org.u2sa.flightgear.link;

import org.u2sa.messages.AircraftState;

/**
 * One reading of a simulated aircraft.
 *
 * @param connected whether the aircraft is present; if not, the state is the last known one
 * @param sequence number of this reading, which distinguishes a new reading from a repeated one; 0
 *     before the first
 * @param measuredAtMicros measurement time on the run's clock [µs]
 * @param state state in GLOBAL, without timestamp and sensor name; the air velocity is in BODY.
 *     Empty before the first reading
 */
public record AircraftReading(
    boolean connected, long sequence, long measuredAtMicros, AircraftState state) {
  /** The value before the first reading. */
  public static AircraftReading none() {
    return new AircraftReading(false, 0, 0, new AircraftState());
  }

  /** The same reading, marked as not connected. */
  AircraftReading lost() {
    return new AircraftReading(false, sequence, measuredAtMicros, state);
  }
}
