package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.ForceCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.marine.BlueRov2;

/**
 * Actuator lost in mid-mission, six thrusters: scored against the truth of the simulated vessel.
 */
class ThrusterLostTest {
  private static final double SETTLING_S = 25.0;

  @Test
  void killThruster_holdingStationInACurrent_holdsOnAndSaysWhatIsLeft() {
    try (SixThrusterDive dive = new SixThrusterDive(0.15, -0.1)) {
      dive.dive(SETTLING_S);
      double killedS = dive.kit.nowS();
      assertThat(dive.worstM(5.0)).isLessThan(0.02);

      dive.thrusters.get("THRUSTER 1").kill();
      dive.dive(20.0);

      assertThat(dive.worstM(20.0)).isLessThan(0.02);
      assertThat(dive.worstHeadingDeg(0.0, 20.0)).isLessThan(1.0);
      assertThat(dive.lastDrivenS("THRUSTER 1")).isLessThan(killedS);
      assertThat(dive.health())
          .isEqualTo("lost: THRUSTER 1; authority left: surge 50 %, sway 50 %, yaw 50 %");
    }
  }

  /** Nobody withdraws the thruster: only its announcements stop. */
  @ParameterizedTest
  @CsvSource({"false, 0.10", "true, 0.10"})
  void processOfAThrusterDies_holdingStation_isNoticedWithinASecond(
      boolean thrustGoesOn, double withinM) {
    try (SixThrusterDive dive = new SixThrusterDive(0.15, -0.1)) {
      dive.moveToAnotherProcess("THRUSTER 2");
      dive.dive(SETTLING_S);
      double diedS = dive.kit.nowS();
      assertThat(dive.worstM(5.0)).isLessThan(0.02);

      dive.dies("THRUSTER 2", thrustGoesOn);
      dive.dive(20.0);

      assertThat(dive.lastDrivenS("THRUSTER 2") - diedS).isBetween(0.3, 1.0);
      assertThat(dive.worstM(20.0)).isLessThan(withinM);
      assertThat(dive.worstM(5.0)).isLessThan(0.02);
      assertThat(dive.health()).startsWith("lost: THRUSTER 2; authority left: ");
    }
  }

  /** Its service obeys and announces itself, but the propeller is gone: only the motion tells. */
  @ParameterizedTest
  @CsvSource({"THRUSTER 1, 0.22", "THRUSTER 2, -0.22", "THRUSTER 3, -0.22", "THRUSTER 4, 0.22"})
  void propellerLost_holdingStationInACurrent_isFoundByTheMotion(
      String thruster, double currentEast) {
    try (SixThrusterDive dive = new SixThrusterDive(currentEast, -0.18)) {
      dive.dive(SETTLING_S);

      dive.thrusters.get(thruster).breaks();
      dive.dive(20.0);

      assertThat(dive.health()).startsWith("lost: " + thruster + "; authority left");
      assertThat(dive.lastDrivenS(thruster) - SETTLING_S).isLessThan(5.0);
      assertThat(dive.worstM(5.0)).isLessThan(0.05);
    }
  }

  /** A bent blade: its service knows nothing, and the motion tells how much is left. */
  @ParameterizedTest
  @CsvSource({"THRUSTER 1, 0.22", "THRUSTER 2, -0.22", "THRUSTER 3, -0.22", "THRUSTER 4, 0.22"})
  void propellerWeakened_holdingStationInACurrent_isEstimatedBelowItsAnnouncement(
      String thruster, double currentEast) {
    try (SixThrusterDive dive = new SixThrusterDive(currentEast, -0.18)) {
      dive.dive(SETTLING_S);

      dive.thrusters.get(thruster).weakens(0.6);
      dive.dive(20.0);

      Matcher said =
          Pattern.compile("weak: " + thruster + " \\((\\d+) %\\); authority left: .*")
              .matcher(dive.health());
      assertThat(said.matches()).as(dive.health()).isTrue();
      assertThat(Double.parseDouble(said.group(1))).isBetween(45.0, 75.0);
      assertThat(dive.worstM(5.0)).isLessThan(0.03);
    }
  }

  /** A thruster that has nothing to do cannot be found out, and is not missed. */
  @Test
  void propellerLost_ofAThrusterAtRest_goesUnnoticed() {
    try (SixThrusterDive dive = new SixThrusterDive(0.22, -0.18)) {
      dive.dive(SETTLING_S);

      dive.thrusters.get("THRUSTER 3").breaks();
      dive.dive(10.0);

      assertThat(dive.health()).isEmpty();
      assertThat(dive.worstM(10.0)).isLessThan(0.02);
    }
  }

  @Test
  void killThenStartAThruster_onTheWayAround_everyCornerIsReached() {
    try (SixThrusterDive dive = new SixThrusterDive(0.1, 0.1)) {
      Point[] corners = {
        Point.of(3.0, 0.0, 10.0),
        Point.of(3.0, 3.0, 11.0),
        Point.of(0.0, 3.0, 11.0),
        Point.of(0.0, 0.0, 10.0)
      };
      double worst = 0.0;
      for (int i = 0; i < corners.length; i++) {
        dive.target = corners[i];
        dive.dive(6.0);
        if (i == 1) {
          dive.thrusters.get("THRUSTER 4").kill();
        } else if (i == 2) {
          dive.start(BlueRov2.thrusters().get(3));
        }
        dive.dive(14.0);
        worst = Math.max(worst, dive.worstM(1.0));
      }

      assertThat(worst).isLessThan(0.15);
      assertThat(dive.worstHeadingDeg(0.0, 75.0)).isLessThan(10.0);
      assertThat(dive.kit.log("Control"))
          .anySatisfy(line -> assertThat(line).contains("lost: THRUSTER 4"))
          .anySatisfy(line -> assertThat(line).contains("full control authority"))
          .noneSatisfy(line -> assertThat(line).contains("respond"));
      assertThat(dive.lastDrivenS("THRUSTER 4")).isGreaterThan(60.0);
    }
  }

  @Test
  void swap_whileHoldingStation_noThrusterJumps() {
    try (SixThrusterDive dive = new SixThrusterDive(0.2, -0.15)) {
      dive.dive(SETTLING_S);
      double[] before = dive.percents();
      dive.swap();
      dive.dive(SixThrusterDive.STEP_S);
      double[] after = dive.percents();

      for (int i = 0; i < before.length; i++) {
        assertThat(after[i]).isCloseTo(before[i], within(1.0));
      }
      dive.dive(5.0);
      assertThat(dive.worstM(5.0)).isLessThan(0.02);
    }
  }

  @Test
  void commandByForce_isTheSameDive() {
    try (SixThrusterDive dive = new SixThrusterDive(0.2, -0.15)) {
      dive.control.setVariable("COMMANDS", "FORCE");
      dive.dive(SETTLING_S);

      assertThat(dive.kit.published(Channels.ACTUATION))
          .anySatisfy(command -> assertThat(command).isInstanceOf(ForceCommand.class));
      assertThat(dive.worstM(2.0)).isLessThan(0.02);
      assertThat(dive.health()).isEmpty();
    }
  }

  @Test
  void derate_toAThird_isAllocatedToByWhatIsLeft() {
    try (SixThrusterDive dive = new SixThrusterDive(0.15, -0.1)) {
      dive.dive(SETTLING_S);

      dive.thrusters.get("THRUSTER 3").derate(30.0);
      dive.dive(5.0);

      assertThat(dive.health()).isEqualTo("authority left: surge 65 %, sway 65 %, yaw 65 %");
    }
  }

  @Test
  void killBothVerticalThrusters_isSaidAndTheRestGoesOn() {
    try (SixThrusterDive dive = new SixThrusterDive(0.15, -0.1)) {
      dive.dive(SETTLING_S);

      dive.thrusters.get("THRUSTER 5").kill();
      dive.thrusters.get("THRUSTER 6").kill();
      dive.dive(10.0);

      assertThat(dive.health()).isEqualTo("lost: THRUSTER 5, THRUSTER 6; cannot control heave");
      assertThat(dive.worstHeadingDeg(0.0, 10.0)).isLessThan(1.0);
    }
  }

  @Test
  void killAllHorizontalThrusters_yawIsEssential_leavesTheRestNeutral() {
    try (SixThrusterDive dive = new SixThrusterDive(0.0, 0.0)) {
      dive.dive(5.0);

      for (int i = 1; i <= 4; i++) {
        dive.thrusters.get("THRUSTER " + i).kill();
      }
      dive.dive(2.0);

      assertThat(dive.health()).endsWith("cannot control surge, sway, yaw; actuators are neutral");
      assertThat(dive.kit.percent("THRUSTER 5")).isZero();
    }
  }

  @Test
  void dive_twice_isTheSameToTheLastBit() {
    assertThat(commandsOfADive()).isEqualTo(commandsOfADive());
  }

  private static String commandsOfADive() {
    try (SixThrusterDive dive = new SixThrusterDive(0.15, -0.1)) {
      dive.dive(5.0);
      dive.thrusters.get("THRUSTER 1").kill();
      dive.dive(5.0);
      return dive.kit.published(Channels.ACTUATION).toString()
          + dive.kit.published(Channels.ACTUATORS);
    }
  }
}
