package org.u2sa.core.planning;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Point;

/** What a planner does while it has no goal to pursue: hold at a place, or nothing. */
final class EndOfMission {
  private final boolean holds;
  private final double radiusM;
  private final LineSettings settings;
  private final WaypointGuidance guidance;
  private Optional<LoiterCircle> circle = Optional.empty();

  /**
   * @param holds whether to hold at all
   * @param radiusM of the circle on which to hold; 0 for the place itself [m]
   * @param settings for the look-ahead
   * @param guidance for the form of the point handed to control
   */
  EndOfMission(boolean holds, double radiusM, LineSettings settings, WaypointGuidance guidance) {
    this.holds = holds;
    this.radiusM = radiusM;
    this.settings = settings;
    this.guidance = guidance;
  }

  /** Forgets where it held: a goal is pursued again. */
  void leave() {
    circle = Optional.empty();
  }

  /**
   * The next step of holding.
   *
   * @param place where to hold; if empty or without coordinates, where the vehicle was when holding
   *     began
   */
  List<NavigationPoint> plan(Vehicle vehicle, Optional<Place> place) {
    if (!holds) {
      return List.of();
    }
    if (circle.isEmpty()) {
      Place centre = place.filter(Place::isHorizontal).orElse(vehicle.place());
      circle = Optional.of(new LoiterCircle(centre, radiusM, vehicle));
    }
    Point ahead = circle.get().ahead(vehicle, settings.lookAheadM(vehicle.speedMps()));
    return List.of(NavigationPoint.at(guidance.bodyPoint(vehicle, ahead)));
  }
}
