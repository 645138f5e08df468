package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.seen.Mover;

/** A vehicle in a take-off from the origin, at a height, and traffic 15 m above the ground. */
class SideStepTest {
  private final AvoidanceBench bench =
      new AvoidanceBench(
          Map.of("VERTICAL CLEARANCE", 5.0, "TRAFFIC CLEARANCE", 5.0, "TRAFFIC HORIZON", 20.0));
  private final SideStep sideStep = new SideStep(bench.world, bench::say);
  private double heightM = 1.3;
  private double downM; // as far as vertical evasion descends

  @BeforeEach
  void seeNothing() {
    bench.see();
  }

  private Point wayBelow(double trafficNorthM, double trafficEastM, double descendsMps) {
    StateInformation state = bench.state.copy().z(-heightM);
    Mover.Heights heights = new Mover.Heights(new double[] {-15.0}, descendsMps, 20.0);
    Mover traffic =
        new Mover(
            "drone",
            0L,
            0.0,
            new double[] {trafficNorthM},
            new double[] {trafficEastM},
            0.0,
            0.0,
            20.0,
            0.0,
            0.0,
            heights);
    return sideStep.way(
        "to",
        Vehicle.of(state).orElseThrow(),
        state,
        Point.of(0.0, 0.0, downM),
        Optional.of(Point.of(0.0, 0.0, 0.0)),
        List.of(traffic),
        bench.settings);
  }

  private static Polygon square(double northM, double eastM, double halfM) {
    Polygon square =
        new Polygon()
            .points(
                List.of(
                    Point.of(northM - halfM, eastM - halfM, 0.0),
                    Point.of(northM + halfM, eastM - halfM, 0.0),
                    Point.of(northM + halfM, eastM + halfM, 0.0),
                    Point.of(northM - halfM, eastM + halfM, 0.0)));
    square.uid("area").x(northM).y(eastM).z(0.0).referenceFrame(ReferenceFrame.LOCAL_NED);
    return square;
  }

  @ParameterizedTest
  @CsvSource({"2.0, 0.0", "0.0, -3.0", "-1.0, -1.0"})
  void way_trafficDescendsOntoIt_leadsAwayOverTheKnownGround(double northM, double eastM) {
    Point way = wayBelow(northM, eastM, 2.0);

    assertThat(Math.hypot(way.x(), way.y())).isCloseTo(8.0, within(0.01));
    assertThat(way.x() * northM + way.y() * eastM)
        .isLessThan(-0.9 * 8.0 * Math.hypot(northM, eastM));
    assertThat(bench.said).hasSize(1);
  }

  @Test
  void way_trafficHasStopped_stillLeadsAside() {
    Point way = wayBelow(2.0, 0.0, 2.0);

    assertThat(wayBelow(2.0, 0.0, 0.0).x()).isEqualTo(way.x());
  }

  @ParameterizedTest
  @CsvSource({
    "2.0, 0.0, 1.3, 0.0", // passes
    "9.0, 2.0, 1.3, 0.0", // descends beside
    "2.0, 2.0, 5.0, 4.0", // the vehicle descends
    "2.0, 2.0, 1.3, -28.0", // or may climb
    "2.0, 2.0, 0.2, 0.0" // or stands
  })
  void way_trafficPassesOrVehicleDescendsOrStands_isTheGivenOne(
      double northM, double descendsMps, double atM, double evadesM) {
    heightM = atM;
    downM = evadesM;

    assertThat(wayBelow(northM, 0.0, descendsMps)).isEqualTo(Point.of(0.0, 0.0, downM));
  }

  @Test
  void way_obstacleAway_leadsBesideIt() {
    bench.see(AvoidanceBench.ball(-5.0, 1.0));
    Point way = wayBelow(2.0, 0.0, 2.0);

    assertThat(way.x()).isLessThan(0.0);
    assertThat(Math.abs(way.y())).isGreaterThan(2.0);
  }

  @Test
  void way_fenceEndsAway_staysInside() {
    sideStep.see(new FenceState().keepIn(List.of(square(5.0, 0.0, 9.0))).keepOut(List.of()));

    assertThat(wayBelow(2.0, 0.0, 2.0).x()).isBetween(-4.0, 2.0);
  }

  @Test
  void way_allAroundIsForbidden_isTheGivenOne() {
    sideStep.see(new FenceState().keepIn(List.of()).keepOut(List.of(square(0.0, 0.0, 9.0))));

    assertThat(wayBelow(2.0, 0.0, 2.0)).isEqualTo(Point.of(0.0, 0.0, downM));
  }

  @Test
  void way_fenceIsNotOnThePlaneOfTheState_isTheGivenOne() {
    Polygon area = square(5.0, 0.0, 50.0);
    area.referenceFrame(ReferenceFrame.GLOBAL);
    sideStep.see(new FenceState().keepIn(List.of(area)).keepOut(List.of()));

    assertThat(wayBelow(2.0, 0.0, 2.0)).isEqualTo(Point.of(0.0, 0.0, downM));
  }
}
