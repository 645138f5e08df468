package org.u2sa.flightgear.link;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.aircraft.ControlInputs;

/** A link to a FlightGear of which the test decides every byte. */
abstract class RawLink {
  static final ControlInputs SOME = new ControlInputs(0.1, -0.2, 0.3, 0.4, 1.0, 0.0, 0.0, 0.0);

  final Clock clock = new SystemClock();
  final StringBuilder troubles = new StringBuilder();
  RawFlightGear flightGear;
  FlightGearLink link;

  @BeforeEach
  void open() throws IOException {
    flightGear = new RawFlightGear();
    link = new FlightGearLink("127.0.0.1", 0, flightGear.inPort(), 0, clock);
  }

  @AfterEach
  void close() throws IOException {
    link.close();
    flightGear.close();
  }

  AircraftReading readUntil(Predicate<AircraftReading> condition) {
    return quickly("a reading").until(() -> link.read(clock.micros()), condition);
  }

  void awaitTrouble(String part) {
    Callable<Boolean> said = () -> troubles.append(link.trouble()).indexOf(part) >= 0;
    quickly(part + " in " + troubles).until(said);
  }

  private static ConditionFactory quickly(String what) {
    return await(what)
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(2))
        .atMost(Duration.ofSeconds(60));
  }
}
