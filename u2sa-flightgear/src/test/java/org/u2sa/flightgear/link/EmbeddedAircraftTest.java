package org.u2sa.flightgear.link;

import org.u2sa.sim.vehicle.VehicleRun;

final class EmbeddedAircraftTest extends AircraftLinkContract {
  private final TickingTime time = new TickingTime();

  @Override
  AircraftLink linkToParkedAircraft() {
    return new EmbeddedAircraft(new VehicleRun(parkedAircraft()));
  }

  @Override
  long nowMicros() {
    return time.next();
  }
}
