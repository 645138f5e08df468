package org.u2sa.gcs.plan;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Waypoint;

/** Orders as fields of the goals after them: the inverse of {@link WayOrders}. */
final class ItemOrders {
  private static final double GROUND_SPEED = 1.0; // as airspeed without wind or current
  private static final double VIEW_NOTHING = 0.0; // modes of DO_SET_ROI
  private static final double VIEW_PLACE = 3.0;

  private final ItemPlaces places;
  private final List<String> lost;
  private final List<String> details;
  private final Set<Integer> stated = new HashSet<>(); // indices of goals with orders before them
  private double speed = WayOrders.VEHICLE_CHOOSES;
  private double imageDistanceM = WayOrders.NO_IMAGES;
  private Optional<Point> view = Optional.empty();
  private boolean startsLanding;
  private boolean isStated; // since the last goal

  ItemOrders(ItemPlaces places, List<String> lost, List<String> details) {
    this.places = places;
    this.lost = lost;
    this.details = details;
  }

  /** Processes an order; false if the item is a different command. */
  boolean take(PlanItem item) {
    switch (item.command()) {
      case PlanItem.CHANGE_SPEED -> speed(item);
      case PlanItem.IMAGE_DISTANCE -> images(item);
      case PlanItem.VIEW -> view = place(item);
      case PlanItem.NO_VIEW -> view = Optional.empty();
      case PlanItem.ANY_VIEW -> anyView(item);
      case PlanItem.LAND_START -> startsLanding = true;
      default -> {
        return false;
      }
    }
    isStated |= item.command() != PlanItem.LAND_START;
    return true;
  }

  private void speed(PlanItem item) {
    double wanted = item.parameter(2);
    if (item.parameter(1) != WayOrders.AIRSPEED && item.parameter(1) != GROUND_SPEED) {
      lose(item, "a speed of type " + item.parameter(1) + "; expected 0 or 1");
      return;
    }
    if (wanted == WayOrders.VEHICLE_CHOOSES || wanted > 0.0) {
      speed = wanted;
    } else if (wanted != WayOrders.UNCHANGED) {
      lose(item, "a speed of " + wanted + " m/s; expected more than 0, -1 or -2");
    }
    if (item.parameter(3) > 0.0) {
      details.add(item.title() + ": a throttle of " + item.parameter(3) + " %");
    }
  }

  private void images(PlanItem item) {
    double distance = item.parameter(1);
    if (distance >= 0.0) {
      imageDistanceM = distance;
    } else if (distance != WayOrders.UNCHANGED) {
      lose(item, "a distance of " + distance + " m; expected 0 or more, or -1");
    }
    if (item.parameter(2) > 0.0) {
      details.add(item.title() + ": a shutter time of " + item.parameter(2) + " ms");
    }
  }

  private void anyView(PlanItem item) {
    if (item.parameter(1) == VIEW_NOTHING) {
      view = Optional.empty();
    } else if (item.parameter(1) == VIEW_PLACE) {
      view = place(item);
    } else {
      lose(item, "a view of mode " + item.parameter(1) + "; expected 0 or 3, a place");
    }
  }

  private Optional<Point> place(PlanItem item) {
    OptionalDouble altitude = places.altitude(item);
    if (altitude.isEmpty() || !places.isPlace(item)) {
      lose(item, "expected latitude, longitude and altitude");
      return Optional.empty();
    }
    return Optional.of(Point.of(item.parameter(6), item.parameter(5), altitude.getAsDouble()));
  }

  /** Applies the orders to the next goal. */
  void applyTo(Waypoint goal, int index) {
    if (speed != WayOrders.VEHICLE_CHOOSES) {
      goal.speed(speed);
    }
    if (imageDistanceM != WayOrders.NO_IMAGES) {
      goal.photoDistance(imageDistanceM);
    }
    view.ifPresent(goal::lookAt);
    if (startsLanding) {
      goal.landingStart(true);
    }
    if (isStated) {
      stated.add(index);
    }
    startsLanding = false;
    isStated = false;
  }

  /** Reports a jump to a goal whose orders differ from those at its origin. */
  void jump(PlanItem item, Waypoint target, int index) {
    boolean isSame =
        speed == target.speed().orElse(WayOrders.VEHICLE_CHOOSES)
            && imageDistanceM == target.photoDistance().orElse(WayOrders.NO_IMAGES)
            && view.equals(target.lookAt());
    if (!isSame && !stated.contains(index)) {
      details.add(
          item.title()
              + ": jumps to an item with a different speed or view, which an item before that must set");
    }
  }

  /** Whether a landing start has no goal after it. */
  boolean isIncomplete() {
    return startsLanding;
  }

  private void lose(PlanItem item, String what) {
    lost.add(item.title() + ": " + what);
  }
}
