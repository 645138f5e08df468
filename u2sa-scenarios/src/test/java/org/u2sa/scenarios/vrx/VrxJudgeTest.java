package org.u2sa.scenarios.vrx;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
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
}
