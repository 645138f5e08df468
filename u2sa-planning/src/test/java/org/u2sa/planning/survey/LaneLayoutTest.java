package org.u2sa.planning.survey;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.curve.Dubins;
import org.u2sa.planning.curve.Pose;

class LaneLayoutTest {
  private static final double SIDE_M = 5.0;

  /** An L of 300 × 200 m without its north-eastern quarter. */
  private static LaneLayout.Cells concave() {
    List<double[]> places = new ArrayList<>();
    for (double north = 0.0; north < 200.0; north += SIDE_M) {
      for (double east = 0.0; east < 300.0; east += SIDE_M) {
        if (north < 100.0 || east < 150.0) {
          places.add(new double[] {north + 2.5, east + 2.5});
        }
      }
    }
    int[] numbers = new int[places.size()];
    double[] norths = new double[places.size()];
    double[] easts = new double[places.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = i;
      norths[i] = places.get(i)[0];
      easts[i] = places.get(i)[1];
    }
    return new LaneLayout.Cells(numbers, norths, easts, SIDE_M);
  }

  private static LaneLayout.Flight wind(double northMps, double eastMps) {
    return new LaneLayout.Flight(40.0, 100.0, 22.0, northMps, eastMps);
  }

  @Test
  void best_concaveArea_everyCellIsUnderALane() {
    LaneLayout.Cells cells = concave();
    List<Lane> lanes = LaneLayout.best(cells, wind(0.0, 5.0));
    for (int i = 0; i < cells.numbers().length; i++) {
      double north = cells.norths()[i];
      double east = cells.easts()[i];
      assertThat(lanes)
          .anyMatch(
              lane ->
                  Math.abs(lane.acrossM(north, east)) <= 20.0 - 0.5 * SIDE_M + 1e-6
                      && lane.alongM(north, east) >= -1e-6
                      && lane.alongM(north, east) <= lane.lengthM() + 1e-6);
    }
  }

  @Test
  void best_calm_fliesAlongTheLongSide() {
    List<Lane> lanes = LaneLayout.best(concave(), wind(0.0, 0.0));
    assertThat(Math.abs(Math.sin(lanes.get(0).courseRad()))).isGreaterThan(0.9);
    assertThat(lanes.size()).isLessThanOrEqualTo(6);
  }

  @Test
  void along_crosswind_lanesLieCloser() {
    int calm = LaneLayout.along(concave(), wind(0.0, 0.0), Math.PI / 2.0).size();
    int across = LaneLayout.along(concave(), wind(12.0, 0.0), Math.PI / 2.0).size();
    assertThat(across).isGreaterThan(calm);
  }

  @Test
  void order_lanesOfAnArea_noLongerThanInTheOrderOfLayout() {
    List<Lane> lanes = LaneLayout.along(concave(), wind(0.0, 0.0), Math.PI / 2.0);
    Pose start = new Pose(-200.0, 0.0, 0.0);
    List<Lane> ordered = LaneOrder.of(lanes, start, 100.0, 40.0);
    assertThat(ordered).hasSameSizeAs(lanes);
    assertThat(wayM(ordered, start)).isLessThanOrEqualTo(wayM(lanes, start));
  }

  @Test
  void best_turnsInPlace_cellsThatTouchAreOneLane() {
    LaneLayout.Flight hovers = new LaneLayout.Flight(40.0, 0.0, 22.0, 0.0, 0.0);
    assertThat(LaneLayout.best(concave(), hovers)).hasSizeLessThanOrEqualTo(6);
    assertThat(LaneLayout.along(concave(), hovers, 0.7)).hasSizeLessThanOrEqualTo(20);
  }

  @Test
  void order_turnsInPlace_nearestEndsByStraightLines() {
    List<Lane> lanes = LaneLayout.along(concave(), wind(0.0, 0.0), Math.PI / 2.0);
    List<Lane> ordered = LaneOrder.of(lanes, new Pose(-200.0, 0.0, 0.0), 0.0, 0.0);
    assertThat(ordered).hasSameSizeAs(lanes);
    for (int i = 1; i < ordered.size(); i++) {
      Pose entry = ordered.get(i).entry(0.0);
      assertThat(ordered.get(i - 1).end().distanceM(entry.northM(), entry.eastM()))
          .isLessThan(160.0); // across the quarter that is missing
    }
  }

  private static double wayM(List<Lane> lanes, Pose start) {
    double sum = 0.0;
    Pose from = start;
    for (Lane lane : lanes) {
      sum += Dubins.shortest(from, lane.entry(40.0), 100.0).lengthM();
      from = lane.end();
    }
    return sum;
  }
}
