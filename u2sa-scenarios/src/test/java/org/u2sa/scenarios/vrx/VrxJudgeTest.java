package org.u2sa.scenarios.vrx;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;

class VrxJudgeTest {
  private static final Footprint OUTLINE = Footprint.rectangle(2.5, 2.5, 2.46, -0.1, 1.3);

  @TempDir private Path folder;
  private double timeS;

  private VrxJudge judge(String world) {
    VrxWorld read = VrxWorldReader.read(VrxWorldReaderTest.WORLDS.resolve(world));
    VrxJudge judge = VrxJudge.of(read, OUTLINE, folder);
    judge.armed(new ArmingState().armed(true), at(VrxWorld.START, 0.0));
    return judge;
  }

  private VehicleTruth at(Point place, double headingRad) {
    return new VehicleTruth(
        timeS, place, new Attitude(0.0, 0.0, headingRad), Point.ORIGIN, Point.ORIGIN, Point.ORIGIN);
  }

  private void sail(VrxJudge judge, double fromNorth, double toNorth, double east) {
    for (int i = 0; i <= 20; i++) {
      timeS += 0.05;
      judge.see(at(Point.of(east, fromNorth + (toNorth - fromNorth) * i / 20.0, 0.0), 0.0));
    }
  }

  private static double score(VrxJudge judge) {
    RunOutcome outcome = judge.outcome();
    return outcome.figures().get("score");
  }

  @Test
  void score_stationOneMetreAndHalfARadianOff_isTheFormulasMean() {
    VrxJudge judge = judge("station.sdf");
    VrxWorld.Goal goal = judge.world().goals().get(0);
    Point place =
        judge.world().plane().point(new Geodetic(goal.longitudeDeg(), goal.latitudeDeg(), 0.0));
    timeS = 5.0; // ready: does not count
    judge.see(at(VrxWorld.START, 0.0));
    timeS = 11.0;
    judge.see(at(place.plus(Point.of(1.0, 0.0, 0.0)), goal.headingRad() + 0.5));
    timeS = 12.0;
    judge.see(at(place, goal.headingRad()));

    assertThat(score(judge)).isCloseTo((1.0 + 0.75 * 0.5) / 2.0, within(1e-6));
  }

  @Test
  void score_threeGatesInOrder_is33() {
    VrxJudge judge = judge("gates.sdf");
    timeS = 10.0;
    sail(judge, 180.0, 190.0, -532.0);
    sail(judge, 200.0, 210.0, -526.0);
    sail(judge, 220.0, 230.0, -536.0);

    assertThat(judge.isOver()).isTrue();
    assertThat(score(judge)).isEqualTo(33.0);
  }

  @Test
  void score_laterGateBeforeTheFirst_isInert() {
    VrxJudge judge = judge("gates.sdf");
    timeS = 10.0;
    sail(judge, 200.0, 210.0, -526.0);

    assertThat(score(judge)).isZero();
  }

  @Test
  void score_secondGateTheWrongWay_isVoid() {
    VrxJudge judge = judge("gates.sdf");
    timeS = 10.0;
    sail(judge, 180.0, 190.0, -532.0);
    sail(judge, 190.0, 210.0, -500.0); // beside the gates
    sail(judge, 210.0, 200.0, -526.0);
    sail(judge, 200.0, 210.0, -526.0);
    sail(judge, 210.0, 220.0, -500.0);
    sail(judge, 220.0, 230.0, -536.0);

    assertThat(score(judge)).isEqualTo(21.0); // first and third, which is the last
  }

  @Test
  void score_touchesTwiceWithinTenSeconds_costsThreePointsOnce() {
    VrxJudge judge = judge("gates.sdf");
    timeS = 10.0;
    sail(judge, 180.0, 190.0, -532.0);
    sail(judge, 193.0, 197.0, -529.0);
    sail(judge, 213.0, 217.0, -531.5);

    assertThat(judge.outcome().contacts()).isEqualTo(2);
    assertThat(score(judge)).isEqualTo(10.0 - 3.0 + 11.0);
  }

  /** Sails around an animal at 6 m, from 20° on. */
  private void circle(VrxJudge judge, int animal, double turns) {
    for (int i = 0; i <= 400; i++) {
      timeS += 0.05;
      Point centre = judge.world().wildlife().animals().get(animal).mover().at(timeS).position();
      double angle = Math.toRadians(20.0) + turns * 2.0 * Math.PI * i / 400.0;
      judge.see(
          at(
              Point.of(centre.x() + 6.0 * Math.cos(angle), centre.y() + 6.0 * Math.sin(angle), 0.0),
              0.0));
    }
  }

  @Test
  void score_bothCircledInTheirDirection_isTimeLessBonuses() {
    VrxJudge judge = judge("animals.sdf");
    timeS = 10.0;
    circle(judge, 1, -1.1); // platypus, clockwise
    circle(judge, 2, 1.1); // turtle, anticlockwise

    assertThat(judge.isOver()).isTrue();
    assertThat(score(judge)).isBetween(36.0 - 90.0, 41.0 - 90.0);
  }

  @Test
  void score_circledTheWrongWayOrNotWhole_givesNoBonus() {
    VrxJudge judge = judge("animals.sdf");
    timeS = 10.0;
    circle(judge, 1, 1.5);
    circle(judge, 2, 0.8);

    assertThat(judge.isOver()).isFalse();
    assertThat(judge.outcome().figures().get("animalsDealtWith")).isEqualTo(1.0); // avoided
  }

  @Test
  void score_nearTheCrocodile_losesItsBonus() {
    VrxJudge judge = judge("animals.sdf");
    timeS = 10.0;
    judge.see(at(Point.of(-540.0, 185.0, 0.0), 0.0));

    assertThat(judge.outcome().figures().get("animalsDealtWith")).isEqualTo(0.0);
  }

  /** Lies at a place of the dock's axes for a time. */
  private void lie(VrxJudge judge, double x, double y, double seconds) {
    Docking docking = judge.world().docking();
    double cos = Math.cos(docking.yawRad());
    double sin = Math.sin(docking.yawRad());
    Point at = docking.place().plus(Point.of(x * cos - y * sin, x * sin + y * cos, 0.0));
    for (int i = 0; i <= seconds * 20.0; i++) {
      timeS += 0.05;
      judge.see(at(at, Math.PI / 2.0 - docking.yawRad()));
    }
  }

  @Test
  void score_rightBayAndSequence_isAllPoints() {
    VrxJudge judge = judge("dock.sdf");
    timeS = 10.0;
    lie(judge, -10.0, 9.0, 1.0);
    judge.reported(new DockBySign().sequence(judge.world().docking().sequence()));
    lie(judge, 1.5, 9.0, 10.2);
    lie(judge, -3.5, 9.0, 1.0);

    assertThat(judge.isOver()).isTrue();
    assertThat(score(judge)).isEqualTo(30.0);
    assertThat(judge.outcome().contacts()).isZero();
  }

  @Test
  void score_wrongBayAfterAWrongSequence_isDockingOnly() {
    VrxJudge judge = judge("dock.sdf");
    timeS = 10.0;
    lie(judge, -10.0, 3.0, 1.0);
    judge.reported(new DockBySign().sequence(List.of(Colour.RED, Colour.RED, Colour.RED)));
    judge.reported(new DockBySign().sequence(judge.world().docking().sequence())); // too late
    lie(judge, 1.5, 3.0, 10.2);
    lie(judge, -3.5, 3.0, 1.0);

    assertThat(score(judge)).isEqualTo(15.0);
  }

  @Test
  void score_leavesTheBayTooSoon_hasNotDocked() {
    VrxJudge judge = judge("dock.sdf");
    timeS = 10.0;
    lie(judge, 1.5, 9.0, 9.0);
    lie(judge, -3.5, 9.0, 1.0);

    assertThat(judge.isOver()).isFalse();
    assertThat(score(judge)).isZero();
  }
}
