package org.u2sa.scenarios.robosub.course;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.sim.vehicle.VehicleTruth;

/** What counts and what does not; places are north, east and down. */
class TaskJudgesTest {
  private static final List<Colour> COLOURS = List.of(Colour.RED, Colour.GREEN);

  /** A vehicle at rest that heads north, with the nose up. */
  private static VehicleTruth at(double north, double east, double down, double pitchRad) {
    return new VehicleTruth(
        10.0,
        Point.of(east, north, -down),
        new Attitude(0.0, pitchRad, 0.0),
        Point.ORIGIN,
        Point.ORIGIN,
        Point.ORIGIN);
  }

  private static SubTaskJudge bin() {
    Point right = Point.of(10.0, 0.0, 3.6);
    return new BinTask(right, Point.of(10.0, 1.5, 3.6), COLOURS, 1L).judge();
  }

  private static SubTaskJudge hoop() {
    Point right = Point.of(10.0, 0.0, 2.0);
    return new TorpedoTask(right, Point.of(10.0, 1.2, 2.0), 0.0, COLOURS, 1L).judge();
  }

  private static void release(SubTaskJudge judge, String actuator, VehicleTruth truth, int times) {
    for (int i = 0; i < times; i++) {
      judge.released(actuator, truth);
    }
  }

  @Test
  void bin_twoMarkersFromAbove_isDone() {
    SubTaskJudge judge = bin();
    release(judge, "DROPPER", at(10.0, 0.05, 2.7, 0.0), 2);

    assertThat(judge.violation()).isEmpty();
    assertThat(judge.counts()).containsEntry("markersInBin", 2);
  }

  @Test
  void bin_markersIntoTheOtherBinOrMoreThanTwo_doNotCount() {
    SubTaskJudge judge = bin();
    release(judge, "DROPPER", at(10.0, 1.5, 2.7, 0.0), 2);
    release(judge, "DROPPER", at(10.0, 0.0, 2.7, 0.0), 2);

    assertThat(judge.violation()).hasValue("bin: 0 of 2 markers inside");
  }

  @Test
  void hoop_twoTorpedoesFromInFront_isDone() {
    SubTaskJudge judge = hoop();
    release(judge, "LAUNCHER", at(8.7, 0.0, 2.0, 0.0), 2);

    assertThat(judge.violation()).isEmpty();
  }

  @Test
  void hoop_noseUpOrFromBehindOrFarAway_doesNotCount() {
    SubTaskJudge judge = hoop();
    release(judge, "LAUNCHER", at(8.7, 0.0, 2.0, 0.3), 1);
    release(judge, "DROPPER", at(8.7, 0.0, 2.0, 0.0), 1);
    release(judge, "LAUNCHER", at(11.0, 0.0, 2.0, 0.0), 1);
    release(judge, "LAUNCHER", at(4.0, 0.0, 2.0, 0.0), 1);

    assertThat(judge.counts()).containsEntry("torpedoesThroughHoop", 0);
  }

  @Test
  void gate_passedOnTheOtherSide_isWrong() {
    SubTaskJudge judge =
        new GateTask(Point.of(5.0, 0.0, 1.5), Point.of(0.0, 1.5, 0.0), true).judge();
    judge.moved(Point.of(4.9, 0.7, 1.5), Point.of(5.1, 0.7, 1.5));

    assertThat(judge.violation()).hasValue("gate: passed on the wrong side");
  }

  @Test
  void buoys_bumpedInTheOtherOrder_doNotCount() {
    SubTaskJudge judge =
        new BuoysTask(List.of(Point.of(5.0, 0.0, 1.5), Point.of(9.0, 0.0, 1.5)), COLOURS).judge();
    judge.touched("green buoy");
    judge.touched("red buoy");

    assertThat(judge.counts()).containsEntry("buoysBumpedInOrder", 0);
    assertThat(judge.violation()).isPresent();
  }
}
