package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.SeenWorld;

/** What the planner closes by itself, seen in what ways cost. The vehicle stands at the origin. */
class VirtualObstaclesTest {
  private static final double RADIUS_M = 0.6;

  private final SeenWorld world =
      new SeenWorld(
          () ->
              new SeenWorld.Reading(
                  0.1, 20.0, new Inflation(RADIUS_M, 1.4, 3.0), 0.65, "corridor", List.of(), 0.0));
  private final StateInformation state =
      new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(0.0).psi(0.0);
  private final VirtualObstacles obstacles = new VirtualObstacles(world);
  private final RouteTrack northward =
      new RouteTrack(
          Route.of(List.of(new Route.Point(0.0, 0.0, false), new Route.Point(8.0, 0.0, false)), 8));

  @BeforeEach
  void beginOnThePlane() {
    world.plane(state);
    update();
  }

  private void update() {
    world.update(state, 0.0, 0.0, 0.0, 0.0);
  }

  private void see(ObjectDescription... objects) {
    world.see(new ObjectList().objects(List.of(objects)), 0L);
    update();
  }

  private static ObjectDescription post(double northM, double eastM) {
    return new Sphere()
        .uid("post " + northM + " " + eastM)
        .objectType("post")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(northM)
        .y(eastM)
        .radius(0.1);
  }

  private boolean isFree(double northM, double eastM) {
    return world.costs().cost(northM, eastM) < Double.POSITIVE_INFINITY;
  }

  /** The way is blocked by a post beside it, which is then no longer seen. */
  private void blockTwice() {
    for (double seconds : new double[] {10.0, 20.0}) {
      see(post(2.5, 0.3));
      obstacles.blocked(northward, Clock.micros(seconds));
      see();
    }
  }

  @Test
  void blocked_twiceAtOneGap_staysClosedThoughNothingStandsThere() {
    assertThat(isFree(2.0, 0.0)).isTrue();
    blockTwice();
    assertThat(isFree(2.0, 0.0)).isFalse();
    assertThat(isFree(2.0, 3.0)).isTrue();
  }

  @Test
  void forgetGaps_afterTwo_opensThem() {
    blockTwice();
    obstacles.forgetGaps();
    update();
    assertThat(isFree(2.0, 0.0)).isTrue();
  }

  @Test
  void closeBehind_betweenTwoLines_theWayBackIsClosed() {
    see(line(-2.0), line(2.0));
    assertThat(isFree(-1.0, 0.0)).isTrue();
    obstacles.closeBehind(new Pose(0.0, 0.0, 0.0), RADIUS_M, 3.5);
    update();
    assertThat(isFree(-1.0, 0.0)).isFalse();
    assertThat(isFree(1.5, 0.0)).isTrue();
  }

  /** Runs from the vehicle's level northward. */
  private static ObjectDescription line(double eastM) {
    return new PolyLine()
        .points(List.of(Point.of(-0.5, eastM, 0.0), Point.of(2.5, eastM, 0.0)))
        .width(0.08)
        .x(0.0)
        .y(eastM)
        .uid("line " + eastM)
        .objectType("line")
        .referenceFrame(ReferenceFrame.LOCAL_NED);
  }

  @Test
  void keepSides_markToPassOnItsLeft_itsRightIsClosed() {
    see(post(3.0, 0.0));
    AvoidanceVariables settings =
        XmlConfiguration.inMemory("PathPlanner", Map.of("PASS SIDES", "post: LEFT"))
            .settings(AvoidanceVariables.class)
            .get();
    assertThat(isFree(3.0, 2.0)).isTrue();
    obstacles.keepSides(new Pose(0.0, 0.0, 0.0), state, Optional.of(northward), settings);
    update();
    assertThat(isFree(3.0, 2.0)).isFalse();
    assertThat(isFree(3.0, -2.0)).isTrue();
  }
}
