package org.u2sa.flightgear.link;

final class EmbeddedAircraftTest extends AircraftLinkContract {
  private final TickingTime time = new TickingTime();

  @Override
  AircraftLink linkToParkedAircraft() {
    return new EmbeddedAircraft(parkedAircraft());
  }

  @Override
  long nowMicros() {
    return time.next();
  }
}
