package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.route.RoutePlanner;
import org.u2sa.planning.route.RoutePlanners;
import org.u2sa.planning.route.RouteRequest;
import org.u2sa.planning.seen.SeenWorld;

/** A truck, 0.32 m wide, in a lane that is open behind it; its goal is behind the lane. */
class PassagesTest {
  private final XmlConfiguration configuration =
      XmlConfiguration.inMemory(
          "PathPlanner",
          Map.of(
              "VEHICLE FRONT",
              0.46,
              "VEHICLE REAR",
              0.1,
              "VEHICLE WIDTH",
              0.32,
              "CLEARANCE",
              0.15,
              "PLANNING SPAN",
              20.0));
  private final AvoidanceVariables variables =
      configuration.settings(AvoidanceVariables.class).get();
  private final RoutePlanner hybrid = RoutePlanners.all(configuration).get("HYBRID");
  private final Passages passages = new Passages(() -> variables, () -> false, hybrid::checksShape);
  private final SeenWorld world = new SeenWorld(passages::reading);
  private final StateInformation state =
      new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(0.0).psi(0.0);

  @BeforeEach
  void beginAtTheOrigin() {
    world.plane(state);
  }

  private static ObjectDescription wall(String uid, double northM, double eastM, boolean isAcross) {
    return new Box()
        .uid(uid)
        .objectType("wall")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(northM)
        .y(eastM)
        .length(isAcross ? 1.5 : 4.0)
        .width(0.1)
        .height(1.0)
        .psi(isAcross ? Math.PI / 2.0 : 0.0);
  }

  private Route plan(double laneM) {
    double asideM = 0.5 * laneM + 0.05;
    world.see(
        new ObjectList()
            .objects(
                List.of(
                    wall("right", 0.0, asideM, false),
                    wall("left", 0.0, -asideM, false),
                    wall("end", 2.1, 0.0, true))),
        0L);
    world.update(state, 0.0, 0.0, 0.0, 0.0);
    return hybrid.plan(
        new RouteRequest(
            new Pose(0.0, 0.0, 0.0),
            -4.0,
            0.0,
            OptionalDouble.empty(),
            0.5,
            new RouteRequest.Mobility(passages.body(), variables.clearance(), 0.9, true),
            world.costs(),
            List.of(),
            List.of(),
            100_000));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.82, 0.86, 0.9})
  void narrow_laneTwiceTheWidthAndClearance_routeLeadsOut(double laneM) {
    assertThat(plan(laneM).exists()).isFalse();
    assertThat(passages.narrow()).isTrue();
    assertThat(plan(laneM).exists()).isTrue();
    assertThat(passages.narrow()).isFalse();
  }

  @Test
  void narrow_laneNarrowerThanTheClearance_isRefused() {
    passages.narrow();
    assertThat(plan(0.6).exists()).isFalse();
  }

  @Test
  void narrow_plannerWithoutTheShape_doesNotBegin() {
    Passages ofGrid = new Passages(() -> variables, () -> false, () -> false);
    assertThat(ofGrid.narrow()).isFalse();
  }
}
