package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.scenarios.cessna.FlightWitness.Moment;

/** The failsafe matrix in flight: what goes wrong, and what the aircraft then truly does. */
@Timeout(240)
class FailsafeMatrixTest {
  private static final double LOITER_RADIUS_M = 800.0; // config/cessna/PathPlanner.xml
  private static final double WIND_MPS = 6.0;
  private static final String WIND = "6@40";

  @TempDir private Path directory;

  /** Flies until the trouble counts. */
  private TroubledFlight flyInto(Trouble trouble, FailsafeAction action)
      throws InterruptedException {
    TroubledFlight flight =
        TroubledFlight.start(directory, 4, WIND, options -> trouble.configure(options, action));
    trouble.prepare(flight);
    flight.flyIntoCruise();
    FlightWitness witness = flight.witness();
    assertThat(witness.arming().armed()).as(witness.arming().toString()).isTrue();
    assertThat(witness.action()).isEqualTo(FailsafeAction.CONTINUE);
    trouble.begin(flight);
    flight.flyUntil(
        () -> witness.causes().stream().anyMatch(cause -> cause.startsWith(trouble.words())), 30.0);
    assertThat(witness.action()).isEqualTo(action);
    return flight;
  }

  @ParameterizedTest(name = "{0} → {1}")
  @CsvSource({
    "ACTUATOR_LINK, CONTINUE",
    "UNCERTAIN_POSITION, HOLD",
    "NO_POSITION, HOLD",
    "ESTIMATOR, HOLD",
    "OPERATOR, RETURN",
    "BATTERY, STOP"
  })
  void trouble_doesWhatTheMatrixSays(Trouble trouble, FailsafeAction action)
      throws InterruptedException {
    try (TroubledFlight flight = flyInto(trouble, action)) {
      require(action, trouble, flight);
    }
  }

  /** Every cause with every action; LAND is LandingFlightTest's, too. */
  static Stream<Arguments> all() {
    List<Arguments> all = new ArrayList<>();
    for (Trouble trouble : Trouble.values()) {
      for (FailsafeAction action : FailsafeAction.values()) {
        if (trouble != Trouble.NO_POSITION || !trouble.needsPosition(action)) {
          all.add(Arguments.of(trouble, action));
        }
      }
    }
    return all.stream();
  }

  @Tag("long")
  @ParameterizedTest(name = "{0} → {1}")
  @MethodSource("all")
  void trouble_ofEachRow_doesWhatTheMatrixSays(Trouble trouble, FailsafeAction action)
      throws InterruptedException {
    try (TroubledFlight flight = flyInto(trouble, action)) {
      require(action, trouble, flight);
    }
  }

  private static void require(FailsafeAction action, Trouble trouble, TroubledFlight flight)
      throws InterruptedException {
    if (trouble == Trouble.ESTIMATOR && action != FailsafeAction.STOP) {
      flight.fly(2.0); // as long as it takes to start it again: without estimates nothing flies
      trouble.end(flight);
    }
    boolean over = trouble == Trouble.ESTIMATOR && action == FailsafeAction.HOLD;
    switch (over ? FailsafeAction.CONTINUE : action) {
      case CONTINUE -> requireOnItsWay(flight);
      case HOLD -> requireHeld(trouble, flight);
      case RETURN -> requireReturned(flight);
      case LAND -> LandingFlightTest.requireLanded(flight);
      case STOP -> requireStopped(trouble, flight);
    }
    assertThat(flight.witness().last().crashed())
        .as(flight.witness().last().toString())
        .isEqualTo(action == FailsafeAction.STOP);
  }

  private static void requireOnItsWay(TroubledFlight flight) throws InterruptedException {
    flight.flyUntil(() -> flight.witness().reached().contains("2"), 200.0);
  }

  private static double distanceM(Moment moment, double eastM, double northM) {
    return Math.hypot(moment.eastM() - eastM, moment.northM() - northM);
  }

  /**
   * On its circle round the place where it was; without a position, on one that the wind drifts.
   */
  private static void requireHeld(Trouble trouble, TroubledFlight flight)
      throws InterruptedException {
    Moment began = flight.witness().last();
    flight.fly(60.0);
    double settledS = flight.nowS();
    flight.fly(240.0);

    double drift = WIND_MPS * (flight.nowS() - began.timeS());
    for (Moment moment : flight.since(settledS)) {
      double radius = distanceM(moment, began.eastM(), began.northM());
      if (trouble == Trouble.NO_POSITION) {
        assertThat(radius).isLessThan(2.0 * LOITER_RADIUS_M + drift);
      } else {
        assertThat(radius).isBetween(LOITER_RADIUS_M - 50.0, LOITER_RADIUS_M + 50.0);
      }
      assertThat(moment.altitudeM()).isBetween(began.altitudeM() - 20.0, began.altitudeM() + 20.0);
    }
    assertThat(flight.witness().reached()).containsExactly("1");
  }

  private static void requireReturned(TroubledFlight flight) throws InterruptedException {
    Moment began = flight.witness().last();
    flight.fly(300.0);
    double arrivedS = flight.nowS();
    flight.fly(180.0);

    assertThat(distanceM(began, 0.0, 0.0)).isGreaterThan(5_000.0);
    for (Moment moment : flight.since(arrivedS)) {
      assertThat(distanceM(moment, 0.0, 0.0)).isLessThan(LOITER_RADIUS_M + 50.0);
      assertThat(moment.heightM()).isGreaterThan(100.0);
    }
  }

  /** Engine and surfaces are neutral, and stay so when the cause is gone. */
  private static void requireStopped(Trouble trouble, TroubledFlight flight)
      throws InterruptedException {
    assertThat(flight.witness().emergencyStop().active()).isTrue();
    assertThat(flight.witness().emergencyStop().reason()).contains(trouble.words());
    trouble.end(flight);
    flight.flyUntil(() -> flight.witness().last().crashed(), 240.0); // glides
    assertThat(flight.witness().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(flight.witness().arming().armed()).isFalse();
    assertThat(flight.witness().arming().reasons())
        .anyMatch(reason -> reason.startsWith("emergency stop by \"SafetyManager\""));
  }

  @Test
  void hold_causeGone_continuesTheMissionByItself() throws InterruptedException {
    try (TroubledFlight flight = flyInto(Trouble.UNCERTAIN_POSITION, FailsafeAction.HOLD)) {
      flight.fly(30.0);
      Trouble.UNCERTAIN_POSITION.end(flight);
      double goneS = flight.nowS();
      flight.flyUntil(() -> flight.witness().action() == FailsafeAction.CONTINUE, 10.0);

      assertThat(flight.nowS() - goneS).isBetween(3.0, 4.0); // CLEAR AFTER
      requireOnItsWay(flight);
    }
  }

  @Test
  void return_causeGone_goesOnUntilAnOperatorArmsAnewAndThenResumesTheMission()
      throws InterruptedException {
    try (TroubledFlight flight = flyInto(Trouble.OPERATOR, FailsafeAction.RETURN)) {
      Trouble.OPERATOR.end(flight);
      flight.fly(60.0);
      assertThat(flight.witness().action()).isEqualTo(FailsafeAction.RETURN);
      assertThat(flight.witness().causes())
          .singleElement()
          .asString()
          .endsWith("(over; stays until armed again)");

      flight
          .witness()
          .say(Channels.ARMING, new ArmCommand().requestId("1").arm(true).operator("Ann"));
      flight.flyUntil(() -> flight.witness().action() == FailsafeAction.CONTINUE, 5.0);

      requireOnItsWay(flight);
    }
  }

  @Test
  void troubles_several_theMostSevereWins() throws InterruptedException {
    try (TroubledFlight flight = flyInto(Trouble.UNCERTAIN_POSITION, FailsafeAction.HOLD)) {
      Trouble.OPERATOR.begin(flight);
      flight.flyUntil(() -> flight.witness().action() == FailsafeAction.RETURN, 10.0);

      assertThat(flight.witness().causes()).hasSize(2);
      assertThat(flight.witness().causes().get(0)).startsWith("operator link");
    }
  }
}
