package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.planning.guidance.WaypointAccuracy;

class WaypointAccuracyTest extends PlannedVehicle {
  private static StateInformation known(double northM, double sigmaM) {
    return state(northM, 0, 0).xSigma(sigmaM).ySigma(0.5 * sigmaM);
  }

  private static Waypoint narrow(String uid, double northM) {
    return waypoint(uid, northM, 0).horizontalThreshold(0.5);
  }

  private String said() {
    kit.advance(0.3); // health is reported
    return String.valueOf(kit.latest(Channels.HEALTH).orElseThrow().remarks());
  }

  @Test
  void goals_thresholdsBelowTheAccuracy_areSaidAtTheStart() {
    kit.start(PathPlanner::new);
    goals(narrow("1", 100), waypoint("2", 200, 0).horizontalThreshold(20.0));

    kit.publish(Channels.STATE, known(0, 2.8));

    assertThat(kit.log("PathPlanner"))
        .filteredOn(line -> line.contains("WARN"))
        .singleElement()
        .asString()
        .contains("waypoint \"1\" may be missed", "known to 2.8 m", "probability of 2 %")
        .contains("thresholds of 5.6 m");
    assertThat(said()).contains("threshold:");
  }

  @Test
  void goals_thresholdsThatTheAccuracyMeets_areNotMentioned() {
    kit.start(PathPlanner::new);
    goals(narrow("1", 100));

    kit.publish(Channels.STATE, known(0, 0.02));

    assertThat(kit.log("PathPlanner")).noneMatch(line -> line.contains("WARN"));
  }

  @Test
  void goals_waypointOfAltitudeAlone_hasNoHorizontalThresholdToMention() {
    kit.start(PathPlanner::new);
    Waypoint up = new Waypoint().uid("up").referenceFrame(ReferenceFrame.LOCAL_NED).z(-3.0);
    goals(up.horizontalThreshold(0.5).verticalThreshold(0.3));

    kit.publish(Channels.STATE, known(0, 2.8).z(0.0));

    assertThat(kit.log("PathPlanner")).noneMatch(line -> line.contains("may be missed"));
  }

  @Test
  void thresholdSigmas_waypointWithinThem_isReachedAndReportedWithThatThreshold() {
    kit.with("THRESHOLD SIGMAS", 2.0).with("ATTEMPTS", 1).start(PathPlanner::new);
    goals(waypoint("1", 100, 4).horizontalThreshold(0.5));

    for (double north = 0; north <= 120; north += 1) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, known(north, 2.8)); // passes at 4 m, whatever it is told
    }

    GoalInformation report = kit.published(Channels.GOAL_REPORTS).get(0);
    assertThat(report.completed()).isTrue();
    assertThat(((Waypoint) report).horizontalThreshold()).isCloseTo(5.6, within(1e-9));
  }

  private int reports(double fromM, double toM) {
    for (double north = fromM; north <= toM; north += 0.5) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, known(north, 1.0));
    }
    return kit.published(Channels.GOAL_REPORTS).size();
  }

  @Test
  void goalReport_edgeOfTheThresholdWithTheUsualCornerLimit_waitsForTheAccuracy() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 100, 0).horizontalThreshold(4.0));

    assertThat(reports(80.0, 97.5)).as("2.5 m before it, 2 sigma from the edge at 2 m").isZero();
    assertThat(reports(98.0, 98.5)).isEqualTo(1);
  }

  @Test
  void surelyWithinM_accuracy_isLeftAsAMargin() {
    assertThat(WaypointAccuracy.surelyWithinM(0.5, known(0, 0.05))).isCloseTo(0.4, within(1e-9));
    assertThat(WaypointAccuracy.surelyWithinM(0.5, known(0, 3.0))).isCloseTo(0.25, within(1e-9));
    assertThat(WaypointAccuracy.surelyWithinM(0.5, state(0, 0, 0))).isEqualTo(0.5);
  }
}
