package org.u2sa.scenarios.encounters;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.rightofway.Rule;

/** The judge on motions that break a rule, and one that breaks none. */
class EncounterScoreTest {
  /** A boat that goes north, and at a time alters its course for a while. */
  private static EncounterScore judged(
      Rule rule, double vesselCourseDeg, double atS, double forS, double turnDeg) {
    double course = Math.toRadians(vesselCourseDeg);
    double north = 150.0 * EncounterCase.OWN_MPS * (1.0 - Math.cos(course));
    double east = -150.0 * EncounterCase.OWN_MPS * Math.sin(course);
    EncounterScore score =
        new EncounterScore(
            new EncounterCase(
                "case",
                List.of(
                    new EncounterCase.Vessel(
                        "A", north, east, course, EncounterCase.OWN_MPS, Set.of(rule)))));
    score.hear("right of way: \"traffic A\": " + rule);
    double boatNorth = 0.0;
    double boatEast = 0.0;
    for (double now = 0.0; now < 260.0; now += 0.5) {
      double heading = now >= atS && now < atS + forS ? Math.toRadians(turnDeg) : 0.0;
      score.see(now, boatNorth, boatEast, heading, EncounterCase.OWN_MPS);
      boatNorth += 0.5 * EncounterCase.OWN_MPS * Math.cos(heading);
      boatEast += 0.5 * EncounterCase.OWN_MPS * Math.sin(heading);
    }
    return score;
  }

  @Test
  void violations_earlyAndClearTurnToStarboard_areNone() {
    EncounterScore score = judged(Rule.HEAD_ON, 180, 30, 60, 40);

    assertThat(score.violations()).isEmpty();
    assertThat(score.score()).isEqualTo(1.0);
  }

  @Test
  void violations_nothingDone_areDistanceAndAction() {
    EncounterScore score = judged(Rule.HEAD_ON, 180, 1000, 1, 0);

    assertThat(score.violations())
        .anyMatch(what -> what.contains("passed at 0.0 m"))
        .anyMatch(what -> what.contains("first action"))
        .anyMatch(what -> what.contains("course changed by only 0"));
    assertThat(score.score()).isZero();
  }

  @Test
  void violations_turnToPort_isWrongSide() {
    assertThat(judged(Rule.HEAD_ON, 180, 30, 60, -40).violations())
        .contains("A was not passed port to port", "the boat turned to port");
  }

  @Test
  void violations_lateAction_isSaid() {
    assertThat(judged(Rule.HEAD_ON, 180, 110, 40, 60).violations())
        .containsExactly("A: first action 40 s before");
  }

  @Test
  void violations_smallAlterationForALongTime_isNotSeen() {
    assertThat(judged(Rule.HEAD_ON, 180, 30, 110, 15).violations())
        .containsExactly("course changed by only 15°");
  }

  @Test
  void violations_crossingAhead_isSaid() {
    assertThat(judged(Rule.CROSSING_GIVE_WAY, 270, 30, 60, -50).violations())
        .contains("A: the boat crossed ahead of it", "the boat turned to port");
  }

  @Test
  void violations_standsOnButTurnsEarly_isSaid() {
    assertThat(judged(Rule.CROSSING_STAND_ON, 90, 30, 60, 40).violations())
        .contains("the boat acted while it still had to stand on");
  }

  @Test
  void violations_otherRuleApplied_isSaid() {
    EncounterCase.Vessel vessel =
        new EncounterCase.Vessel("A", 400.0, 0.0, Math.PI, 1.5, Set.of(Rule.HEAD_ON));
    EncounterScore score = new EncounterScore(new EncounterCase("case", List.of(vessel)));
    score.hear("right of way: \"traffic A\": " + Rule.OVERTAKING);
    score.see(0.0, 0.0, 0.0, 0.0, 1.5);

    assertThat(score.violations()).contains("A: rule applied: OVERTAKING");
  }
}
