package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.RouteTrack;

/** What the planner closes by itself, seen in what ways cost. The vehicle stands at the origin. */
class VirtualObstaclesTest {

  private final AvoidanceBench bench = new AvoidanceBench();
  private final VirtualObstacles obstacles = new VirtualObstacles(bench.world);
  private final RouteTrack northward = new RouteTrack(AvoidanceBench.northward(8.0, 8.0));

  private boolean isFree(double northM, double eastM) {
    return bench.world.costs().cost(northM, eastM) < Double.POSITIVE_INFINITY;
  }

  /** The way is blocked by a post beside it, which is then no longer seen. */
  private void blockTwice() {
    for (double seconds : new double[] {10.0, 20.0}) {
      bench.see(AvoidanceBench.post(2.5, 0.3));
      obstacles.blocked(northward, Clock.micros(seconds));
      bench.see();
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
    bench.see();
    assertThat(isFree(2.0, 0.0)).isTrue();
  }

  @Test
  void closeUnseen_untilNoOtherRouteExists_closesWhatIsBehind() {
    obstacles.closeUnseen(new Pose(0.0, 0.0, 0.0), 1.0);
    bench.see();
    assertThat(isFree(-1.0, 0.0)).isFalse();
    assertThat(isFree(0.0, 0.0)).isTrue();
    assertThat(isFree(1.0, 0.0)).isTrue();

    obstacles.forgetGaps();
    bench.see();
    assertThat(isFree(-1.0, 0.0)).isTrue();
  }

  @Test
  void closeBehind_betweenTwoLines_theWayBackIsClosed() {
    bench.see(line(-2.0), line(2.0));
    assertThat(isFree(-1.0, 0.0)).isTrue();
    obstacles.closeBehind(new Pose(0.0, 0.0, 0.0), AvoidanceBench.RADIUS_M, 3.5);
    bench.see();
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
    bench.see(AvoidanceBench.post(3.0, 0.0));
    AvoidanceVariables settings =
        XmlConfiguration.inMemory("PathPlanner", Map.of("PASS SIDES", "post: LEFT"))
            .settings(AvoidanceVariables.class)
            .get();
    assertThat(isFree(3.0, 2.0)).isTrue();
    obstacles.keepSides(new Pose(0.0, 0.0, 0.0), bench.state, Optional.of(northward), settings);
    bench.see();
    assertThat(isFree(3.0, 2.0)).isFalse();
    assertThat(isFree(3.0, -2.0)).isTrue();
  }
}
