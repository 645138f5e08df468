package org.u2sa.scenarios.roboboat.gate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

class GateApproachTest {
  private static final double HALF_BEAM_M = 0.35;
  private static final Gate SOUTHWARD =
      new Gate(Point.of(10.0, 1.2, 0.0), Point.of(10.0, -1.2, 0.0));

  private static List<PlanarShape> buoys(Point... others) {
    List<PlanarShape> buoys = new ArrayList<>();
    List<Point> places = new ArrayList<>(List.of(SOUTHWARD.left(), SOUTHWARD.right()));
    places.addAll(List.of(others));
    places.forEach(at -> buoys.add(PlanarShape.disc("buoy", at.x(), at.y(), 0.25)));
    return buoys;
  }

  @Property(tries = 100)
  void plan_boatComesOutOfTheChannel_turnsClearOfTheBuoyAtItsEnd(
      @ForAll @DoubleRange(min = 13.0, max = 16.0) double north,
      @ForAll @DoubleRange(min = -1.0, max = 1.0) double east,
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double courseRad) {
    List<PlanarShape> buoys = buoys(Point.of(20.0, 1.5, 0.0));

    GateApproach way =
        GateApproach.plan(new Pose(north, east, courseRad), SOUTHWARD, buoys).orElseThrow();

    Point here = Point.of(north, east, 0.0);
    for (int i = 0; i < 400 && way.path().leftM() > 0.0; i++) {
      here = way.path().ahead(SailingPath.SPACING_M);
      way.path().follow(here);
      for (PlanarShape buoy : buoys) {
        assertThat(buoy.distanceM(here.x(), here.y())).isGreaterThan(HALF_BEAM_M + 0.5);
      }
    }
    assertThat(here.x()).isCloseTo(10.0 + way.runM(), within(0.3));
    assertThat(here.y()).isCloseTo(0.0, within(0.3));
  }

  @Test
  void plan_gateBehindAWall_isEmpty() {
    PlanarShape wall =
        PlanarShape.wall("wall", new double[] {12.0, 12.0}, new double[] {-50.0, 50.0});

    assertThat(GateApproach.plan(new Pose(30.0, 0.0, Math.PI), SOUTHWARD, List.of(wall))).isEmpty();
  }

  @Test
  void movedM_gateTurned_growsWithTheRun() {
    GateApproach way =
        GateApproach.plan(new Pose(40.0, 0.0, Math.PI), SOUTHWARD, buoys()).orElseThrow();
    Gate turned = new Gate(Point.of(10.2, 1.2, 0.0), Point.of(9.8, -1.2, 0.0));

    assertThat(way.movedM(turned)).isCloseTo(way.runM() * 0.4 / 2.4, within(0.1));
  }
}
