package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.scenarios.cessna.FlightWitness.Moment;
import org.u2sa.testkit.Repository;

/** The predictive fence in flight: it is never crossed, whatever the wind. */
@Timeout(240)
class FenceFlightTest {
  @TempDir private Path directory;

  private LaunchOptions fenced(LaunchOptions options, Path fence, FailsafeAction action) {
    return options
        .override("SafetyManager", "FENCE", fence.toString())
        .override("SafetyManager", "ON FENCE", action.name());
  }

  /** Smallest distance from a fence across the mission [m], negative outside. */
  private double leastM(long seed, String wind, FailsafeAction action) throws InterruptedException {
    FencedOff fence = FencedOff.ofSeed(seed);
    try (TroubledFlight flight =
        TroubledFlight.start(
            directory, seed, wind, options -> fenced(options, fence.in(directory), action))) {
      flight.flyUntil(() -> flight.witness().action() == action, 700.0);
      double atM = fence.marginM(flight.witness().last());
      flight.fly(200.0);

      double leastM = flight.since(0.0).stream().mapToDouble(fence::marginM).min().orElseThrow();
      System.out.printf(
          Locale.ROOT,
          "fence, seed %d, wind %s, %s: at %.0f m, least %.0f m%n",
          seed,
          wind,
          action,
          atM,
          leastM);
      assertThat(flight.witness().told()).as("nothing but that, once").hasSize(1);
      return leastM;
    }
  }

  @ParameterizedTest(name = "seed {0}, wind {1}, {2}")
  @CsvSource({"2, 8@20, RETURN", "3, 8@90, HOLD", "4, 8@180, RETURN", "5, 8@270, HOLD"})
  void fence_acrossTheMission_isNotCrossed(long seed, String wind, FailsafeAction action)
      throws InterruptedException {
    assertThat(leastM(seed, wind, action)).isPositive();
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}")
  @ValueSource(
      ints = {
        11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33,
        34, 35, 36, 37, 38, 39, 40
      })
  void fence_anywhereInAnyWind_isNotCrossed(int seed) throws InterruptedException {
    String wind = "8@" + seed * 47 % 360;
    assertThat(leastM(seed, wind, FailsafeAction.RETURN)).isPositive();
    assertThat(leastM(seed, wind, FailsafeAction.HOLD)).isPositive();
  }

  @Test
  void ceiling_belowAWaypoint_isNotCrossed() throws IOException, InterruptedException {
    Path shipped = Repository.root().resolve("config/cessna/fence.xml");
    Path fence = directory.resolve("low.xml");
    String text = Files.readString(shipped);
    assertThat(text).contains("<ceiling unit=\"ft\">4500</ceiling>");
    Files.writeString(fence, text.replace("unit=\"ft\">4500<", "unit=\"m\">420<"));
    try (TroubledFlight flight =
        TroubledFlight.start(
            directory, 6, "6@200", options -> fenced(options, fence, FailsafeAction.RETURN))) {
      flight.flyUntil(() -> flight.witness().action() == FailsafeAction.RETURN, 300.0);
      flight.fly(120.0);

      assertThat(flight.since(0.0).stream().mapToDouble(Moment::altitudeM).max().orElseThrow())
          .isBetween(330.0, 420.0);
    }
  }
}
