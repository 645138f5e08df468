package org.u2sa.gcs.plan;

import java.util.List;
import java.util.function.Consumer;
import org.u2sa.messages.goal.Station;

/** Stations as items: holds, circles and delays. */
final class StationItems {
  private static final double YES = 1.0;
  private static final double NO_TIME = -1.0; // of day, of NAV_DELAY

  private StationItems() {}

  /**
   * The item of a station.
   *
   * @param place latitude, longitude and altitude; 0, 0 for the present position
   * @param thresholdM horizontal threshold; 0 without one
   * @param heading on the station [deg], or NaN
   * @param detail receives what the item cannot express
   */
  static PlanItem of(
      int id,
      Station station,
      List<Double> place,
      double thresholdM,
      double heading,
      Consumer<String> detail) {
    double radius = station.radius().orElse(0.0);
    double exit = station.towardsNext() ? YES : 0.0;
    double stay = station.duration().orElse(Double.NaN);
    boolean isHere = station.x().isEmpty() || station.y().isEmpty();
    boolean isCircle = isHere || radius != 0.0 || station.towardsNext();
    boolean isHold = stay > 0.0 && station.turns().isEmpty() && !isCircle;
    if (isHold) {
      return PlanItem.at(
          id, PlanItem.WAYPOINT, PlanItem.GLOBAL, place, stay, thresholdM, 0.0, heading);
    }
    if (thresholdM > 0.0) {
      detail.accept("stays within horizontalThreshold " + thresholdM + " m");
    }
    if (station.turns().isPresent()) {
      station.duration().ifPresent(also -> detail.accept("has turns and duration " + also));
      double turns = station.turns().getAsDouble();
      return circle(id, PlanItem.LOITER_TURNS, place, turns, exit, radius, heading, detail);
    }
    if (station.duration().isEmpty()) {
      if (station.towardsNext()) {
        detail.accept("has towardsNext without an end");
      }
      return PlanItem.at(
          id, PlanItem.LOITER_UNLIMITED, PlanItem.GLOBAL, place, 0.0, 0.0, radius, heading);
    }
    if (stay == 0.0) {
      return circle(id, PlanItem.LOITER_TO_ALTITUDE, place, exit, radius, 0.0, heading, detail);
    }
    boolean isDelay = isHere && radius == 0.0 && exit == 0.0 && station.z().isEmpty();
    return isDelay && Double.isNaN(heading)
        ? PlanItem.order(id, PlanItem.DELAY, stay, NO_TIME, NO_TIME, NO_TIME)
        : circle(id, PlanItem.LOITER_TIME, place, stay, exit, radius, heading, detail);
  }

  private static PlanItem circle(
      int id,
      int command,
      List<Double> place,
      double first,
      double second,
      double third,
      double heading,
      Consumer<String> detail) {
    if (!Double.isNaN(heading)) {
      detail.accept("has psi of " + heading + " deg in addition");
    }
    return PlanItem.at(
        id, command, PlanItem.GLOBAL, place, first, second, third, Double.NaN); // path to the next
  }
}
