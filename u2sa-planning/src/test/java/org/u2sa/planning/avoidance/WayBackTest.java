package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.avoidance.VirtualObstacles.WayBack;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

class WayBackTest {
  private static final double CIRCLE_M = 0.6;
  private static final double REACH_M = 3.5;
  private static final Pose NORTHWARD = new Pose(10.0, 20.0, 0.0);

  /** A line that begins so far north and runs north. */
  private static PlanarShape line(double fromNorth, double east) {
    return new PlanarShape(
        "line",
        PlanarShape.Kind.CHAIN,
        new double[] {fromNorth, fromNorth + 1.0, fromNorth + 2.0},
        new double[] {east, east, east},
        0.04,
        -1.0,
        1.0);
  }

  private static Optional<PlanarShape> closed(PlanarShape... shapes) {
    return WayBack.closed(List.of(shapes), NORTHWARD, CIRCLE_M, REACH_M);
  }

  @Test
  void closed_beforeALane_leadsFromLineEndToLineEndBehindTheVehicle() {
    PlanarShape wall = closed(line(10.8, 18.0), line(10.5, 22.5)).orElseThrow();
    assertThat(wall.count()).isEqualTo(3);
    assertThat(wall.northM(0)).isCloseTo(10.8, offset(1e-9));
    assertThat(wall.eastM(0)).isCloseTo(18.0, offset(1e-9));
    assertThat(wall.northM(2)).isCloseTo(10.5, offset(1e-9));
    assertThat(wall.eastM(2)).isCloseTo(22.5, offset(1e-9));
    assertThat(wall.northM(1)).as("the vehicle can still turn").isLessThan(10.0 - CIRCLE_M);
    assertThat(wall.eastM(1)).isCloseTo(20.0, offset(1e-9));
  }

  @Test
  void closed_lineToOneSideOnly_isNone() {
    assertThat(closed(line(10.0, 18.0))).isEmpty();
    assertThat(closed(line(10.0, 22.0))).isEmpty();
  }

  @Test
  void closed_lineTooFarAway_isNone() {
    assertThat(closed(line(10.0, 18.0), line(10.0, 23.6))).isEmpty();
  }

  @Test
  void closed_barrelsToBothSides_isNone() {
    assertThat(
            closed(
                PlanarShape.disc("barrel", 10.0, 18.0, 0.3),
                PlanarShape.disc("barrel", 10.0, 22.0, 0.3)))
        .isEmpty();
  }
}
