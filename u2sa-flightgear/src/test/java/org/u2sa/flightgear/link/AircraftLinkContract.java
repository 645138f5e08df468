package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.function.Predicate;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.atmosphere.Wind;

/** What every {@link AircraftLink} promises, whichever simulator is behind it. */
abstract class AircraftLinkContract {
  static final double LONGITUDE_DEG = -157.943183;
  static final double LATITUDE_DEG = 21.325247;
  static final double ELEVATION_M = 5.3;
  static final double HEADING_RAD = 1.5;
  static final ControlInputs FULL_THROTTLE = ControlInputs.neutral().withThrottle(1.0);

  private AircraftLink link;

  static Cessna172 parkedAircraft() {
    RunwayStart start = new RunwayStart(LONGITUDE_DEG, LATITUDE_DEG, ELEVATION_M, HEADING_RAD);
    return Cessna172.onRunway(start, Wind.calm(), true);
  }

  /** A link to an aircraft that stands on the runway with its engine idling. */
  abstract AircraftLink linkToParkedAircraft() throws Exception;

  /** The time of the run, which goes on with each call. */
  abstract long nowMicros();

  @AfterEach
  void closeLink() {
    if (link != null) {
      link.close();
    }
  }

  @Test
  void read_aircraftOnTheRunway_saysWhereItStands() throws Exception {
    link = linkToParkedAircraft();
    AircraftReading reading = readUntil(each -> each.connected() && each.sequence() > 3);
    assertThat(reading.state().x().orElse(0.0)).isCloseTo(LONGITUDE_DEG, within(1e-6));
    assertThat(reading.state().y().orElse(0.0)).isCloseTo(LATITUDE_DEG, within(1e-6));
    assertThat(reading.state().z().orElse(0.0)).isBetween(ELEVATION_M + 0.5, ELEVATION_M + 2.0);
    assertThat(reading.state().heightAboveGround().orElse(0.0)).isCloseTo(0.0, within(0.2));
    assertThat(reading.state().psi().orElse(0.0)).isCloseTo(HEADING_RAD, within(0.01));
    assertThat(reading.state().theta().orElse(0.0)).isBetween(0.0, 0.1);
    assertThat(reading.state().engineRpm().orElse(0.0)).isBetween(400.0, 1_000.0);
    assertThat(reading.state().weightOnWheels()).isTrue();
    assertThat(reading.state().engineStarting()).isFalse();
    assertThat(reading.state().crashed()).isFalse();
  }

  @Test
  void write_fullThrottle_aircraftGathersSpeedAlongItsHeading() throws Exception {
    link = linkToParkedAircraft();
    readUntil(AircraftReading::connected);
    link.write(FULL_THROTTLE);
    AircraftReading reading = readUntil(each -> each.state().fluidxDot().orElse(0.0) > 5.0);
    assertThat(reading.state().xDot().orElse(0.0)).isGreaterThan(3.0);
    assertThat(reading.state().calibratedAirspeed().orElse(0.0))
        .isCloseTo(reading.state().fluidxDot().orElse(0.0), within(0.5));
    assertThat(reading.state().engineRpm().orElse(0.0)).isGreaterThan(1_500.0);
  }

  @Test
  void read_again_sequenceAndTimeGrowTogether() throws Exception {
    link = linkToParkedAircraft();
    AircraftReading before = readUntil(AircraftReading::connected);
    AircraftReading after = readUntil(each -> each.sequence() > before.sequence());
    assertThat(after.measuredAtMicros()).isGreaterThan(before.measuredAtMicros());
    assertThat(after.measuredAtMicros()).isLessThanOrEqualTo(nowMicros());
  }

  @Test
  void trouble_readTwice_secondIsEmpty() throws Exception {
    link = linkToParkedAircraft();
    readUntil(AircraftReading::connected);
    link.trouble();
    assertThat(link.trouble()).isEmpty();
  }

  AircraftReading readUntil(Predicate<AircraftReading> condition) {
    return await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(2))
        .atMost(Duration.ofSeconds(60))
        .until(() -> link.read(nowMicros()), condition);
  }

  private static Offset<Double> within(double value) {
    return Offset.offset(value);
  }

  /** A clock that goes on by 20 ms with each look. */
  static final class TickingTime {
    private long micros;

    long next() {
      micros += Clock.MICROS_PER_SECOND / 50;
      return micros;
    }
  }
}
