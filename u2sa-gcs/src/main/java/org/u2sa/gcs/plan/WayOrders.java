package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;

/**
 * Orders before the items of goals: speed, images and view of the camera, which hold until the next
 * order of their kind, and the start of the landing.
 */
final class WayOrders {
  static final double AIRSPEED = 0.0; // through the air or water, as in goals
  static final double VEHICLE_CHOOSES = -2.0; // speed of DO_CHANGE_SPEED
  static final double UNCHANGED = -1.0; // speed, throttle and distance
  static final double NO_IMAGES = 0.0; // distance of DO_SET_CAM_TRIGG_DIST
  private static final double AT_ONCE = 1.0; // the first image

  private final boolean hasImages;
  private final boolean hasView;
  private double speed = VEHICLE_CHOOSES;
  private double imageDistanceM = NO_IMAGES;
  private Optional<Point> view = Optional.empty();

  /**
   * @param goals all goals of the mission; if none uses the camera, no camera orders are written
   */
  WayOrders(List<GoalInformation> goals) {
    hasImages = goals.stream().anyMatch(goal -> imageDistanceM(goal) > 0.0);
    hasView =
        goals.stream().anyMatch(goal -> goal instanceof Waypoint at && at.lookAt().isPresent());
  }

  private static double imageDistanceM(GoalInformation goal) {
    return goal instanceof Waypoint at ? at.photoDistance().orElse(NO_IMAGES) : NO_IMAGES;
  }

  /**
   * The orders before a goal.
   *
   * @param isTarget whether the mission jumps to it: then all orders are repeated, because those at
   *     the jump's origin are unknown
   * @param id number of the first order
   */
  List<PlanItem> before(Waypoint goal, boolean isTarget, int id) {
    List<PlanItem> orders = new ArrayList<>();
    double wanted = goal.speed().orElse(VEHICLE_CHOOSES);
    if (wanted != speed || isTarget) {
      orders.add(PlanItem.order(id, PlanItem.CHANGE_SPEED, AIRSPEED, wanted, UNCHANGED));
    }
    double distance = imageDistanceM(goal);
    if (distance != imageDistanceM || isTarget && hasImages) {
      orders.add(
          PlanItem.order(id + orders.size(), PlanItem.IMAGE_DISTANCE, distance, 0.0, AT_ONCE));
    }
    if (!goal.lookAt().equals(view) || isTarget && hasView) {
      orders.add(view(id + orders.size(), goal.lookAt()));
    }
    if (goal.landingStart()) {
      orders.add(PlanItem.order(id + orders.size(), PlanItem.LAND_START));
    }
    speed = wanted;
    imageDistanceM = distance;
    view = goal.lookAt();
    return orders;
  }

  private static PlanItem view(int id, Optional<Point> at) {
    return at.map(
            point ->
                PlanItem.at(
                    id, PlanItem.VIEW, PlanItem.GLOBAL, List.of(point.y(), point.x(), point.z())))
        .orElseGet(() -> PlanItem.order(id, PlanItem.NO_VIEW));
  }
}
