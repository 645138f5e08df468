package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.scenarios.cessna.FlightWitness.Moment;

/** LAND: from wherever it is to the runway of config/cessna/landing.xml, until it stands. */
@Timeout(240)
class LandingFlightTest {
  private static final double RUNWAY_LENGTH_M = 3_700.0; // PHNL 08L, from home to the east
  private static final double HALF_WIDTH_M = 22.0;
  private static final double HARDEST_SINK_MPS = 3.5; // the gear breaks at 3.66

  @TempDir private Path directory;

  private void land(long seed, String wind) throws InterruptedException {
    land(seed, wind, false);
  }

  private void land(long seed, String wind, boolean shear) throws InterruptedException {
    try (TroubledFlight flight =
        TroubledFlight.start(
            directory,
            seed,
            wind,
            options ->
                options
                    .override("SafetyManager", "ON OPERATOR LOSS", "LAND")
                    .override("Simulator", "WIND SHEAR", shear))) {
      flight.flyIntoCruise();
      Trouble.OPERATOR.begin(flight);
      flight.flyUntil(() -> flight.witness().action() == FailsafeAction.LAND, 10.0);
      requireLanded(flight);
    }
  }

  static void requireLanded(TroubledFlight flight) throws InterruptedException {
    FlightWitness witness = flight.witness();
    double beganS = flight.nowS();
    flight.flyUntil(() -> witness.last().onGround() || witness.last().crashed(), 1_000.0);
    List<Moment> before = flight.since(flight.nowS() - 0.2);
    double sink = before.stream().mapToDouble(moment -> -moment.climbMps()).max().orElseThrow();
    Moment touched = witness.last();
    flight.flyUntil(() -> witness.last().speedMps() < 0.5, 60.0);
    flight.fly(30.0);
    Moment stands = witness.last();

    System.out.printf(
        "landed %.0f s later %.0f m behind the threshold, sink %.1f m/s, %.0f m/s; stands at %.0f m%n",
        touched.timeS() - beganS, touched.eastM(), sink, touched.speedMps(), stands.eastM());
    assertThat(stands.crashed()).isFalse();
    assertThat(sink).isLessThan(HARDEST_SINK_MPS);
    for (Moment moment : List.of(touched, stands)) {
      assertThat(moment.eastM()).isBetween(0.0, RUNWAY_LENGTH_M);
      assertThat(Math.abs(moment.northM())).isLessThan(HALF_WIDTH_M);
    }
    assertThat(stands.speedMps()).isLessThan(0.5);
    assertThat(witness.phase()).isEqualTo("STOPPED");
  }

  @ParameterizedTest(name = "seed {0}, wind {1}")
  @CsvSource({"21, 12@0"})
  void land_acrossAndWithTheWind_standsOnTheRunway(long seed, String wind)
      throws InterruptedException {
    land(seed, wind);
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}, wind {1}")
  @CsvSource({"5, 8@180", "10, 8@270"})
  void land_inMoreWinds_standsOnTheRunway(long seed, String wind) throws InterruptedException {
    land_acrossAndWithTheWind_standsOnTheRunway(seed, wind);
  }

  /** 7 m/s near the ground are 13 m/s where it cruises. */
  @Test
  void land_throughWindShear_standsOnTheRunway() throws InterruptedException {
    land(31, "7@160", true);
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
  void land_inAnyWind_standsOnTheRunway(int seed) throws InterruptedException {
    land(seed, "8@" + 18 * seed);
  }
}
