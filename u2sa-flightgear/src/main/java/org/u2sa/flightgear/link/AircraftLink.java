package org.u2sa.flightgear.link;

import org.u2sa.sim.aircraft.ControlInputs;

/**
 * All that the {@link Simulator} service knows of a simulated aircraft: FlightGear, the stand-in
 * that speaks its protocol, and the embedded one look alike.
 */
public interface AircraftLink extends AutoCloseable {
  /**
   * The newest reading; returns at once. A lost aircraft is no exception: its last reading is
   * returned as not connected.
   *
   * @param nowMicros time of the run's clock [µs], to which an aircraft that is simulated in
   *     lockstep is brought
   */
  AircraftReading read(long nowMicros);

  /**
   * Sets the controls; they hold until set again. Returns at once; what cannot be sent is lost, and
   * {@link #trouble} says so.
   */
  void write(ControlInputs controls);

  /** What has gone wrong or right since the last call, for the log; empty if nothing. */
  String trouble();

  /** Ends the connection; the controls were set neutral before, if that was wanted. */
  @Override
  void close();
}
