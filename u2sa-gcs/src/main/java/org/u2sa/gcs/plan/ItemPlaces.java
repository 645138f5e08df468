package org.u2sa.gcs.plan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;

/** Converts items to waypoints, stations and landings, without names, speeds and order. */
final class ItemPlaces {
  /** Commands of items that are goals. */
  static final Set<Integer> COMMANDS =
      Set.of(
          PlanItem.WAYPOINT,
          PlanItem.LOITER_UNLIMITED,
          PlanItem.LOITER_TURNS,
          PlanItem.LOITER_TIME,
          PlanItem.LOITER_TO_ALTITUDE,
          PlanItem.DELAY,
          PlanItem.LAND,
          PlanItem.TAKE_OFF);

  private static final Set<Integer> FRAMES =
      Set.of(
          PlanItem.GLOBAL,
          PlanItem.GLOBAL_INT,
          PlanItem.RELATIVE,
          PlanItem.RELATIVE_INT,
          10, // MAV_FRAME_GLOBAL_TERRAIN_ALT
          11); // likewise, _INT
  private static final double FULL_TURN_DEG = 360.0;

  private final OptionalDouble homeAltitudeM;
  private final List<String> lost;
  private final List<String> details;

  /**
   * @param home for altitudes relative to it
   * @param lost receives items that are not places, one line each
   * @param details receives parameters without a corresponding field
   */
  ItemPlaces(Optional<StationPlan.Place> home, List<String> lost, List<String> details) {
    homeAltitudeM = home.map(StationPlan.Place::altitudeM).orElse(OptionalDouble.empty());
    this.lost = lost;
    this.details = details;
  }

  /** The goal of an item; empty if it cannot be expressed. */
  Optional<Waypoint> waypoint(PlanItem item) {
    return switch (item.command()) {
      case PlanItem.LOITER_UNLIMITED -> circle(item, new Station(), item.parameter(3), 0.0);
      case PlanItem.LOITER_TURNS ->
          item.parameter(1) > 0.0
              ? circle(withoutHeading(item), new Station().turns(item.parameter(1)), 3, 2)
              : lost(item, item.parameter(1) + " turns; expected more than 0");
      case PlanItem.LOITER_TIME ->
          circle(withoutHeading(item), new Station().duration(stay(item)), 3, 2);
      case PlanItem.LOITER_TO_ALTITUDE ->
          circle(withoutHeading(item), new Station().duration(0.0), 2, 1);
      case PlanItem.DELAY ->
          item.parameter(1) > 0.0
              ? Optional.of(new Station().duration(item.parameter(1)))
              : lost(item, "until a time of day; expected a number of seconds");
      case PlanItem.LAND -> landing(item);
      case PlanItem.TAKE_OFF -> takeOff(item);
      default -> hold(item);
    };
  }

  private static PlanItem withoutHeading(PlanItem item) {
    return item.with(4, Double.NaN); // style of the path to the next item
  }

  private static double stay(PlanItem item) {
    return item.parameter(1) > 0.0 ? item.parameter(1) : 0.0; // NaN: not given
  }

  private Optional<Waypoint> hold(PlanItem item) {
    if (item.parameter(3) != 0.0 && !Double.isNaN(item.parameter(3))) {
      detail(item, "a pass-by radius of " + item.parameter(3) + " m");
    }
    double stayS = stay(item);
    Optional<Waypoint> goal =
        position(item, stayS > 0.0 ? new Station().duration(stayS) : new Waypoint());
    if (item.parameter(2) > 0.0) {
      goal.ifPresent(at -> at.horizontalThreshold(item.parameter(2)));
    }
    return goal;
  }

  private Optional<Waypoint> circle(PlanItem item, Station station, int radius, int exit) {
    return circle(item, station, item.parameter(radius), item.parameter(exit));
  }

  /** A circle; around the present position if latitude and longitude are 0. */
  private Optional<Waypoint> circle(
      PlanItem item, Station station, double radiusM, double towardsNext) {
    if (radiusM != 0.0 && !Double.isNaN(radiusM)) {
      station.radius(radiusM);
    }
    if (towardsNext > 0.0) {
      station.towardsNext(true);
    }
    boolean isHere = item.parameter(5) == 0.0 && item.parameter(6) == 0.0;
    if (!isHere) {
      return position(item, station);
    }
    if (item.parameter(PlanItem.PARAMETERS) != 0.0) { // 0: the present altitude
      altitude(item).ifPresent(station::z);
    }
    return Optional.of(station);
  }

  private Optional<Waypoint> landing(PlanItem item) {
    if (item.parameter(1) > 0.0 || item.parameter(2) > 0.0) {
      detail(item, "an abort altitude or a precision landing");
    }
    Optional<Waypoint> goal = position(item, new Landing());
    return goal.filter(at -> at.z().isEmpty()).isPresent()
        ? lost(item, "no altitude of the ground")
        : goal;
  }

  /** With a place, it becomes a waypoint there: vehicles take off by themselves. */
  private Optional<Waypoint> takeOff(PlanItem item) {
    if (item.parameter(1) > 0.0) {
      detail(item, "a pitch of " + item.parameter(1) + " deg");
    }
    boolean isHere = item.parameter(5) == 0.0 && item.parameter(6) == 0.0;
    OptionalDouble altitude = isHere ? altitude(item) : OptionalDouble.empty();
    if (altitude.isPresent()) {
      double heading = item.parameter(4);
      Waypoint climb = new TakeOff().z(altitude.getAsDouble());
      return Optional.of(Double.isFinite(heading) ? climb.psi(radians(heading)) : climb);
    }
    return position(item, new Waypoint());
  }

  private Optional<Waypoint> position(PlanItem item, Waypoint goal) {
    if (!FRAMES.contains(item.frame())) {
      return lost(item, "frame " + item.frame() + "; expected one with latitude and longitude");
    }
    double latitude = item.parameter(5);
    double longitude = item.parameter(6);
    if (!isPlace(item)) {
      return lost(item, "latitude " + latitude + ", longitude " + longitude + " is not a position");
    }
    goal.x(longitude).y(latitude);
    altitude(item).ifPresent(goal::z);
    double heading = item.parameter(4);
    if (Double.isFinite(heading)) {
      goal.psi(radians(heading));
    }
    return Optional.of(goal);
  }

  private static double radians(double headingDeg) {
    return Math.toRadians((headingDeg % FULL_TURN_DEG + FULL_TURN_DEG) % FULL_TURN_DEG);
  }

  /** Whether latitude and longitude are possible; 0, 0 means the present position. */
  boolean isPlace(PlanItem item) {
    double latitude = item.parameter(5);
    double longitude = item.parameter(6);
    return Math.abs(latitude) <= FULL_TURN_DEG / 4
        && Math.abs(longitude) <= FULL_TURN_DEG / 2
        && !(latitude == 0.0 && longitude == 0.0);
  }

  /** Altitude above mean sea level [m]; empty if the item has none, or it cannot be expressed. */
  OptionalDouble altitude(PlanItem item) {
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

  private Optional<Waypoint> lost(PlanItem item, String what) {
    lose(item, what);
    return Optional.empty();
  }

  private void lose(PlanItem item, String what) {
    lost.add(item.title() + ": " + what);
  }

  private void detail(PlanItem item, String what) {
    details.add(item.title() + ": " + what);
  }
}
