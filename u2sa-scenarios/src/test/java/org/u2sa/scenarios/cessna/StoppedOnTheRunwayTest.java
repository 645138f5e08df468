package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;

/** What keeps the Cessna on the ground: checks that fail, an emergency stop, an operator. */
@Timeout(120)
class StoppedOnTheRunwayTest {
  private static final String WIND = "6@270"; // from behind: it would roll

  @TempDir private Path directory;

  private static void requireStanding(TroubledFlight flight) throws InterruptedException {
    double fromM = flight.witness().last().eastM();
    flight.fly(20.0);
    assertThat(flight.witness().last().eastM()).isBetween(fromM - 0.5, fromM + 0.5);
    assertThat(flight.witness().last().onGround()).isTrue();
  }

  @Test
  void arm_actuatorMissing_standsAndSaysWhy() throws InterruptedException {
    try (TroubledFlight flight =
        TroubledFlight.start(
            directory,
            1,
            WIND,
            options -> options.override("SafetyManager", "REQUIRED ACTUATORS", "THROTTLE, GEAR"))) {
      flight.fly(10.0);

      assertThat(flight.witness().arming().armed()).isFalse();
      assertThat(flight.witness().arming().reasons()).containsExactly("actuators: missing: GEAR");
      requireStanding(flight);
    }
  }

  @Test
  void arm_landWithoutAMissionForIt_standsAndSaysWhy() throws InterruptedException {
    try (TroubledFlight flight =
        TroubledFlight.start(
            directory,
            1,
            WIND,
            options ->
                options
                    .override("SafetyManager", "ON LOW BATTERY", "LAND")
                    .override("MissionManager", "LAND MISSION", ""))) {
      flight.fly(10.0);

      assertThat(flight.witness().arming().reasons())
          .containsExactly(
              "failsafe matrix: ON LOW BATTERY is LAND, but the Mission Manager has loaded no LAND MISSION");
      requireStanding(flight);
    }
  }

  @Test
  void emergencyStop_inTheTakeOffRun_brakesToAStandstillUntilClearedAndArmed()
      throws InterruptedException {
    try (TroubledFlight flight = TroubledFlight.start(directory, 1, WIND, options -> options)) {
      FlightWitness witness = flight.witness();
      flight.flyUntil(() -> !witness.moments().isEmpty() && witness.last().speedMps() > 15.0, 60.0);
      EmergencyStop stop = new EmergencyStop().active(true).operator("Ann").reason("dog");
      witness.say(Channels.EMERGENCY_STOP, stop);
      flight.flyUntil(() -> witness.last().speedMps() < 0.1, 30.0);
      requireStanding(flight);

      witness.say(
          Channels.EMERGENCY_STOP,
          new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann"));
      flight.fly(1.0);
      requireStanding(flight); // the clear alone moves nothing
      assertThat(witness.arming().reasons()).isEmpty();
      witness.say(Channels.ARMING, new ArmCommand().requestId("1").arm(true).operator("Ann"));
      flight.fly(1.0);
      assertThat(witness.arming().armed()).isTrue();
    }
  }
}
