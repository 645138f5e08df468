package org.u2sa.flightgear.link;

import org.u2sa.core.control.fixedwing.AircraftState;

/**
 * One reading of a simulated aircraft.
 *
 * @param connected whether the aircraft is there; if not, the state is the last known one
 * @param sequence counts readings, so that a new one is told from one read before; 0 if there was
 *     none yet
 * @param measuredAtMicros when it was measured, by the run's clock [µs]
 * @param state in GLOBAL, without timestamp and sensor name; the air's velocity is in BODY. Empty
 *     if there was none yet
 */
public record AircraftReading(
    boolean connected, long sequence, long measuredAtMicros, AircraftState state) {
  /** No reading yet. */
  public static AircraftReading none() {
    return new AircraftReading(false, 0, 0, new AircraftState());
  }

  /** The same reading of an aircraft that is not there any more. */
  AircraftReading lost() {
    return new AircraftReading(false, sequence, measuredAtMicros, state);
  }
}
