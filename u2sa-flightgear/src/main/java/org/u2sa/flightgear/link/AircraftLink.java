package org.u2sa.flightgear.link;

import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Connection of the {@link Simulator} service to a simulated aircraft: FlightGear, a stand-in that
 * speaks its protocol, or the embedded aircraft.
 */
public interface AircraftLink extends AutoCloseable {
  /**
   * Returns the newest reading without blocking. If the aircraft is lost, returns its last reading
   * as not connected instead of throwing.
   *
   * @param nowMicros the run's clock [µs]; an aircraft in lockstep is advanced to this time
   */
  AircraftReading read(long nowMicros);

  /**
   * Sets the controls, which hold until set again. Does not block. Controls that cannot be sent are
   * dropped and reported by {@link #trouble}.
   */
  void write(ControlInputs controls);

  /** Faults and recoveries since the last call, for the log; empty if none. */
  String trouble();

  /** Closes the connection. Does not neutralise the controls. */
  @Override
  void close();
}
