package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.seen.PlanningPlane;

/** Reports path changes to the log and displays. Confined to the planner's thread. */
final class PathNews {
  private final Supplier<AvoidanceVariables> settings;
  private final BiConsumer<String, Boolean> say;
  private Optional<PlannedPath> path = Optional.empty(); // not yet taken
  private PathStatus status = PathStatus.FOLLOWED;
  private RouteTrack announced;
  private String announcedReason = "";

  /**
   * @param say reports a message to the operator; true for a warning
   */
  PathNews(Supplier<AvoidanceVariables> settings, BiConsumer<String, Boolean> say) {
    this.settings = settings;
    this.say = say;
  }

  void begin() {
    status = PathStatus.FOLLOWED;
  }

  /** Returns path changes for displays once; empty if none. */
  Optional<PlannedPath> take() {
    Optional<PlannedPath> now = path;
    path = Optional.empty();
    return now;
  }

  /**
   * Status of the path after a step.
   *
   * @param hasRecovered whether the vehicle had to free itself on the way to this goal
   */
  static PathStatus status(
      ArcChoice choice, Optional<String> givenUp, boolean hasRecovered, RouteKeeper routes) {
    if (givenUp.isPresent()) {
      return PathStatus.GIVEN_UP;
    }
    if (choice.kind() == ArcChoice.Kind.BRAKE) {
      return PathStatus.BRAKING;
    }
    boolean isFreeing = routes.track().isEmpty() && routes.obstacle().isEmpty();
    if (isFreeing && hasRecovered) {
      return PathStatus.RECOVERING;
    }
    return choice.kind() == ArcChoice.Kind.WAIT ? PathStatus.WAITING : PathStatus.FOLLOWED;
  }

  /**
   * Reports changes, if any.
   *
   * @param named path with the names of the goal and the planner
   * @param why reason why there is no route or the goal is abandoned, or empty
   * @param downM down coordinate of the path's points on its plane [m]
   */
  void announce(
      Supplier<PlannedPath> named,
      PathStatus now,
      String why,
      Optional<RouteTrack> track,
      PlanningPlane plane,
      double downM) {
    String reason = reason(now, why, track);
    boolean same = now == status;
    status = now;
    if (!same && !reason.isEmpty()) {
      say.accept(reason, now == PathStatus.BRAKING);
    }
    boolean newRoute = track.isPresent() && track.get() != announced;
    boolean otherReason = track.isEmpty() && !reason.equals(announcedReason);
    if (same && !newRoute && !otherReason) {
      return;
    }
    announced = track.orElse(null);
    announcedReason = reason;
    PlannedPath news = named.get();
    news.status(now).referenceFrame(plane.frame()).points(points(track, plane, downM));
    if (!reason.isEmpty()) {
      news.reason(reason);
    }
    track.ifPresent(route -> news.cost(route.cost()));
    path = Optional.of(news);
  }

  private String reason(PathStatus now, String why, Optional<RouteTrack> track) {
    return switch (now) {
      case BRAKING ->
          settings.get().stops() ? "collision imminent: braking" : "collision imminent: turning";
      case WAITING -> track.isEmpty() ? why : "waiting for traffic or a route";
      case GIVEN_UP -> why;
      default -> "";
    };
  }

  private static List<Point> points(Optional<RouteTrack> track, PlanningPlane plane, double downM) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; track.isPresent() && i < track.get().count(); i++) {
      points.add(plane.point(track.get().northM(i), track.get().eastM(i), downM));
    }
    return points;
  }
}
