package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.seen.PlanningPlane;

/** What is said of a path, and that nothing is said twice. */
class PathNewsTest {
  private static final PlanningPlane PLANE =
      PlanningPlane.at(new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED));

  private final List<String> said = new ArrayList<>();
  private final PathNews news =
      new PathNews(
          XmlConfiguration.inMemory("PathPlanner", Map.of()).settings(AvoidanceSettings.class)::get,
          (text, isTrouble) -> said.add((isTrouble ? "trouble: " : "") + text));

  private static Optional<RouteTrack> eastTo(double eastM) {
    return Optional.of(
        new RouteTrack(
            Route.of(
                List.of(new Route.Point(0.0, 0.0, false), new Route.Point(0.0, eastM, false)),
                7.0)));
  }

  private Optional<PlannedPath> announced(
      PathStatus status, String why, Optional<RouteTrack> track) {
    news.announce(
        () -> new PlannedPath().goal("gate").planner("GRID"), status, why, track, PLANE, -2.0);
    return news.take();
  }

  @Test
  void announce_newRoute_isShownOnce() {
    Optional<RouteTrack> track = eastTo(5.0);
    PlannedPath path = announced(PathStatus.FOLLOWED, "", track).orElseThrow();
    assertThat(path.points()).containsExactly(Point.of(0.0, 0.0, -2.0), Point.of(0.0, 5.0, -2.0));
    assertThat(path.cost()).hasValue(7.0);
    assertThat(announced(PathStatus.FOLLOWED, "", track)).isEmpty();
    assertThat(announced(PathStatus.FOLLOWED, "", eastTo(6.0))).isPresent();
    assertThat(said).isEmpty();
  }

  @Test
  void announce_anotherReasonWithoutARoute_isShownOnce() {
    PathStatus waits = PathStatus.WAITING;
    assertThat(announced(waits, "no way", Optional.empty()).orElseThrow().reason())
        .hasValue("no way");
    assertThat(announced(waits, "no way", Optional.empty())).isEmpty();
    assertThat(announced(waits, "the goal is occupied", Optional.empty()).orElseThrow().reason())
        .hasValue("the goal is occupied");
    assertThat(announced(waits, "the goal is occupied", Optional.empty())).isEmpty();
  }

  @Test
  void announce_brakes_isTrouble() {
    Optional<RouteTrack> track = eastTo(5.0);
    announced(PathStatus.FOLLOWED, "", track);
    assertThat(announced(PathStatus.BRAKING, "", track)).isPresent();
    assertThat(announced(PathStatus.BRAKING, "", track)).isEmpty();
    assertThat(said).containsExactly("trouble: collision imminent: braking");
  }
}
