package org.u2sa.flightgear.link;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.AircraftState;

/** Channels of simulated flights. */
public final class FlightChannels {
  /** True state of the aircraft, for scoring; flight services must not subscribe to it. */
  public static final Channel<AircraftState> TRUTH =
      Channel.latest("truth", AircraftState.TYPE, AircraftState::sensorName);

  private FlightChannels() {}
}
