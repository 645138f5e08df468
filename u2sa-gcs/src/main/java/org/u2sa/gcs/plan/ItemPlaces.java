package org.u2sa.gcs.plan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;

/** Items at a place as waypoints and stations, without names, speeds and order. */
final class ItemPlaces {
  private static final Set<Integer> FRAMES =
      Set.of(
          PlanItem.GLOBAL,
          PlanItem.GLOBAL_INT,
          PlanItem.RELATIVE,
          PlanItem.RELATIVE_INT,
          10, // MAV_FRAME_GLOBAL_TERRAIN_ALT
          11); // likewise, _INT
  private static final double CLIMBED_WITHIN_M = 10.0; // of the altitude of a take-off
  private static final double FULL_TURN_DEG = 360.0;

  private final OptionalDouble homeAltitudeM;
  private final List<String> lost;
  private final List<String> details;

  /**
   * @param home for altitudes relative to it
   * @param lost receives items that are no place, a line each
   * @param details receives parameters that goals do not have
   */
  ItemPlaces(Optional<StationPlan.Place> home, List<String> lost, List<String> details) {
    homeAltitudeM = home.map(StationPlan.Place::altitudeM).orElse(OptionalDouble.empty());
    this.lost = lost;
    this.details = details;
  }

  /** The goal that an item is; empty if it is lost. */
  Optional<Waypoint> waypoint(PlanItem item) {
    return switch (item.command()) {
      case PlanItem.LOITER_UNLIMITED -> position(item, Double.NaN, 0.0);
      case PlanItem.LOITER_TIME -> position(item.with(4, Double.NaN), stay(item), 0.0);
      case PlanItem.TAKE_OFF -> takeOff(item);
      default -> position(item, stay(item), item.parameter(2));
    };
  }

  private static double stay(PlanItem item) {
    return item.parameter(1) > 0.0 ? item.parameter(1) : 0.0; // NaN: not given
  }

  /** Vehicles take off by themselves; what is left is the place behind, or the altitude. */
  private Optional<Waypoint> takeOff(PlanItem item) {
    if (item.parameter(1) > 0.0) {
      detail(item, "a pitch of " + item.parameter(1) + " deg");
    }
    boolean isHere = item.parameter(5) == 0.0 && item.parameter(6) == 0.0;
    OptionalDouble altitude = isHere ? altitude(item) : OptionalDouble.empty();
    if (altitude.isPresent()) {
      Waypoint climb = new Waypoint().z(altitude.getAsDouble());
      return Optional.of(climb.verticalThreshold(CLIMBED_WITHIN_M));
    }
    return position(item, 0.0, 0.0);
  }

  /**
   * @param stayS time to stay [s]; 0: none, NaN: with no end
   */
  private Optional<Waypoint> position(PlanItem item, double stayS, double radiusM) {
    if (!FRAMES.contains(item.frame())) {
      lose(item, "frame " + item.frame() + "; expected one with latitude and longitude");
      return Optional.empty();
    }
    double latitude = item.parameter(5);
    double longitude = item.parameter(6);
    boolean isPlace =
        Math.abs(latitude) <= FULL_TURN_DEG / 4
            && Math.abs(longitude) <= FULL_TURN_DEG / 2
            && !(latitude == 0.0 && longitude == 0.0);
    if (!isPlace) { // 0, 0 means the present position
      lose(item, "latitude " + latitude + ", longitude " + longitude + " is no place");
      return Optional.empty();
    }
    if (item.parameter(3) != 0.0 && !Double.isNaN(item.parameter(3))) {
      detail(item, "a radius of " + item.parameter(3) + " m to pass or to circle");
    }
    Waypoint goal = stayS == 0.0 ? new Waypoint() : new Station();
    if (goal instanceof Station station && stayS > 0.0) {
      station.duration(stayS);
    }
    goal.x(longitude).y(latitude);
    altitude(item).ifPresent(goal::z);
    if (radiusM > 0.0) {
      goal.horizontalThreshold(radiusM);
    }
    double heading = item.parameter(4);
    if (Double.isFinite(heading)) {
      goal.psi(Math.toRadians((heading % FULL_TURN_DEG + FULL_TURN_DEG) % FULL_TURN_DEG));
    }
    return Optional.of(goal);
  }

  private OptionalDouble altitude(PlanItem item) {
    double z = item.parameter(7);
    if (Double.isNaN(z)) {
      return OptionalDouble.empty();
    }
    switch (item.frame()) {
      case PlanItem.GLOBAL, PlanItem.GLOBAL_INT:
        return OptionalDouble.of(z);
      case PlanItem.RELATIVE, PlanItem.RELATIVE_INT:
        if (homeAltitudeM.isPresent()) {
          return OptionalDouble.of(homeAltitudeM.getAsDouble() + z);
        }
        lose(item, "its altitude is relative to a home without altitude");
        return OptionalDouble.empty();
      default:
        lose(
            item,
            "an altitude in frame "
                + item.frame()
                + "; expected MAV_FRAME_GLOBAL or GLOBAL_RELATIVE_ALT");
        return OptionalDouble.empty();
    }
  }

  private void lose(PlanItem item, String what) {
    lost.add(item.title() + ": " + what);
  }

  private void detail(PlanItem item, String what) {
    details.add(item.title() + ": " + what);
  }
}
