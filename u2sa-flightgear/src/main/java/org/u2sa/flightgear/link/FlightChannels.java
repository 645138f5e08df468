package org.u2sa.flightgear.link;

import org.u2sa.core.control.fixedwing.AircraftState;
import org.u2sa.interfaces.communication.Channel;

/** Channels that only simulated flights have. */
public final class FlightChannels {
  /** What the aircraft really does, for scoring; no service that flies may listen to it. */
  public static final Channel<AircraftState> TRUTH =
      Channel.latest("truth", AircraftState.TYPE, AircraftState::sensorName);

  private FlightChannels() {}
}
