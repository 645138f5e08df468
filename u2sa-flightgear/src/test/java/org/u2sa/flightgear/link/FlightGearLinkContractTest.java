package org.u2sa.flightgear.link;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

final class FlightGearLinkContractTest extends AircraftLinkContract {
  private final Clock clock = new SystemClock();
  private StandInFlightGear standIn;

  @Override
  AircraftLink linkToParkedAircraft() throws IOException {
    standIn =
        new StandInFlightGear(
            parkedAircraft(), StandInSetup.ready(100.0, 10.0), "127.0.0.1", 0, 0, clock);
    FlightGearLink link =
        new FlightGearLink("127.0.0.1", 0, standIn.inPort(), standIn.propertyPort(), clock);
    standIn.start("127.0.0.1", link.outPort());
    return link;
  }

  @Override
  long nowMicros() {
    return clock.micros();
  }

  @AfterEach
  void endStandIn() {
    standIn.close();
  }
}
