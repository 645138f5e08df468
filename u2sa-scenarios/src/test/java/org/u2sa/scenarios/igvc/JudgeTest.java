package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;

/** The judge, on tracks made for each of his rules: a vehicle 1 m long and wide, driving north. */
class JudgeTest {
  private static final double STEP_S = 0.05;

  private final CourseBuilder builder = new CourseBuilder(Point.ORIGIN, 0.0, false);
  private double timeS;
  private double north;

  private Judge judge() {
    return judge(Judge.RUN_S);
  }

  private Judge judge(double runS) {
    builder.start(Point.ORIGIN, Point.of(0.0, 1.0, 0.0));
    builder.waypoint(Point.of(0.0, 40.0, 0.0));
    return new Judge(builder.course("test"), 0.5, 0.5, 1.0, runS);
  }

  private void lane(double halfM) {
    for (int side = -1; side <= 1; side += 2) {
      double x = side * halfM;
      builder.line(Course.BOUNDARY, List.of(Point.of(x, -5.0, 0.0), Point.of(x, 100.0, 0.0)));
    }
  }

  private VehicleTruth truth(double east, double speedMps) {
    return new VehicleTruth(
        timeS,
        Point.of(east, north, 0.0),
        new Attitude(0.0, 0.0, 0.0),
        Point.of(0.0, speedMps, 0.0),
        Point.ORIGIN,
        Point.ORIGIN);
  }

  private void drive(Judge judge, double east, double speedMps, double seconds) {
    for (int i = 0; i < Math.round(seconds / STEP_S); i++) {
      timeS += STEP_S;
      north += speedMps * STEP_S;
      judge.see(truth(east, speedMps));
    }
  }

  private static int count(Judge judge, String name) {
    return judge.outcome().counts().get(name);
  }

  @Test
  void see_insideTheLane_nothingIsCalled() {
    lane(1.524);
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 30.0);
    RunOutcome outcome = judge.outcome();
    assertThat(outcome.isClean()).isTrue();
    assertThat(outcome.figures().get("distanceM")).isBetween(29.9, 30.0);
    assertThat(outcome.figures().get("averageSpeedMps")).isBetween(0.99, 1.01);
    assertThat(judge.isOver()).isFalse();
  }

  @Test
  void see_redFlagToTheRightBlueToTheLeft_areAsTheyShould() {
    builder.flag(Point.of(1.0, 5.0, 0.0), true);
    builder.flag(Point.of(-1.0, 10.0, 0.0), false);
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    assertThat(count(judge, "flagsOnWrongSide")).isZero();
  }

  @Test
  void see_flagsOnTheWrongSides_areCountedAndNamedButSpoilNoRun() {
    builder.flag(Point.of(-1.0, 5.0, 0.0), true);
    builder.flag(Point.of(1.0, 10.0, 0.0), false);
    builder.flag(Point.of(3.0, 12.0, 0.0), false); // of another lane
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    assertThat(count(judge, "flagsOnWrongSide")).isEqualTo(2);
    assertThat(judge.log())
        .anyMatch(line -> line.endsWith("has passed red flag 1 on the wrong side"))
        .anyMatch(line -> line.endsWith("has passed blue flag 1 on the wrong side"));
    assertThat(judge.outcome().isClean()).isTrue();
  }

  @Test
  void see_sideOnTheInnerEdgeOfTheLine_isOneCrossing() {
    lane(1.524);
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 2.0);
    drive(judge, 1.524 - 0.5 - 0.03, 1.0, 5.0); // the line is 38 mm wide to each side
    assertThat(count(judge, "lineCrossings")).isEqualTo(1);
    assertThat(judge.outcome().isClean()).isFalse();
    assertThat(judge.log()).anyMatch(line -> line.endsWith("is on lane boundary 2"));
  }

  @Test
  void see_overTheEndOfTheCourse_isACrossing() {
    builder.line(Course.END, List.of(Point.of(-2.0, 3.0, 0.0), Point.of(2.0, 3.0, 0.0)));
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 5.0);
    assertThat(count(judge, "lineCrossings")).isEqualTo(1);
  }

  @Test
  void see_sideAHandBesideTheLine_isNoCrossing() {
    lane(1.524);
    Judge judge = judge();
    drive(judge, 1.524 - 0.5 - 0.05, 1.0, 5.0);
    assertThat(count(judge, "lineCrossings")).isZero();
  }

  @Test
  void see_overAndBackOverALine_isTwoCrossings() {
    lane(1.524);
    Judge judge = judge();
    drive(judge, 1.2, 1.0, 1.0);
    drive(judge, 0.0, 1.0, 3.0);
    drive(judge, 1.2, 1.0, 1.0);
    assertThat(count(judge, "lineCrossings")).isEqualTo(2);
  }

  @Test
  void see_barrelAtTheCorner_isOneTouch() {
    builder.barrel(Point.of(0.75, 10.0, 0.0));
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    assertThat(count(judge, "touches")).isEqualTo(1);
    assertThat(count(judge, "lineCrossings")).isZero();
  }

  @Test
  void see_barrelAHandBesideTheVehicle_isNoTouch() {
    builder.barrel(Point.of(0.85, 10.0, 0.0));
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    assertThat(count(judge, "touches")).isZero();
  }

  @Test
  void see_overAPothole_isATouch() {
    builder.pothole(Point.of(0.6, 10.0, 0.0));
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    assertThat(count(judge, "touches")).isEqualTo(1);
  }

  @Test
  void see_fortyFourFeetBelowOneMileAnHour_endsTheRun() {
    Judge judge = judge();
    drive(judge, 0.0, 0.44, 31.0);
    assertThat(judge.isOver()).isTrue();
    assertThat(judge.outcome().violations()).singleElement().asString().contains("too slow");
  }

  @Test
  void see_fortyFourFeetAboveOneMileAnHour_goesOn() {
    Judge judge = judge();
    drive(judge, 0.0, 0.46, 31.0);
    assertThat(judge.isOver()).isFalse();
    assertThat(judge.outcome().isClean()).isTrue();
  }

  @Test
  void see_fasterThanFiveMilesAnHour_isAViolationOnce() {
    Judge judge = judge();
    drive(judge, 0.0, 2.3, 3.0);
    drive(judge, 0.0, 1.0, 1.0);
    drive(judge, 0.0, 2.3, 3.0);
    assertThat(judge.outcome().violations()).singleElement().asString().contains("5 mph");
    assertThat(judge.isOver()).isFalse();
  }

  @Test
  void see_restForAMinuteAndAStep_endsTheRun() {
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    drive(judge, 0.0, 0.0, 59.0);
    assertThat(judge.isOver()).isFalse();
    drive(judge, 0.0, 0.0, 2.0);
    assertThat(judge.isOver()).isTrue();
    assertThat(judge.outcome().figures().get("stoppedSeconds")).isBetween(59.0, 61.0);
  }

  @Test
  void see_twoRestsOfFortySeconds_goesOn() {
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 20.0);
    drive(judge, 0.0, 0.0, 40.0);
    drive(judge, 0.0, 1.0, 1.0);
    drive(judge, 0.0, 0.0, 40.0);
    assertThat(judge.isOver()).isFalse();
  }

  @Test
  void see_waitBeforeTheStart_doesNotCount() {
    Judge judge = judge();
    drive(judge, 0.0, 0.0, 300.0);
    drive(judge, 0.0, 1.0, 100.0);
    assertThat(judge.isOver()).isFalse();
    assertThat(judge.outcome().figures().get("stoppedSeconds")).isZero();
  }

  @Test
  void see_sixMinutes_endTheRun() {
    Judge judge = judge();
    drive(judge, 0.0, 1.0, 359.0);
    assertThat(judge.isOver()).isFalse();
    drive(judge, 0.0, 1.0, 2.0);
    assertThat(judge.isOver()).isTrue();
  }

  @Test
  void see_longerRun_endsAfterItsOwnTime() {
    Judge judge = judge(600.0);
    drive(judge, 0.0, 1.0, 599.0);
    assertThat(judge.isOver()).isFalse();
    drive(judge, 0.0, 1.0, 2.0);
    assertThat(judge.isOver()).isTrue();
    assertThat(judge.log()).anyMatch(line -> line.contains("the 10 minutes are over"));
  }
}
