package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.plan.StationPlan;
import org.u2sa.messages.frame.Geodetic;

/** Rally points as items and back (mavlink.io/en/services/mission, rally points). */
final class RallyShapes {
  private static final int RALLY_POINT = 5100; // MAV_CMD_NAV_RALLY_POINT
  private static final Set<Integer> ABOVE_SEA = Set.of(0, 5); // MAV_FRAME_GLOBAL, _INT
  private static final Set<Integer> ABOVE_HOME = Set.of(3, 6); // MAV_FRAME_GLOBAL_RELATIVE_ALT…
  private static final double PER_DEGREE = 1.0e7;
  private static final int MAX_LATITUDE = 900_000_000; // 1e-7 deg
  private static final int MAX_LONGITUDE = 1_800_000_000;

  private RallyShapes() {}

  /**
   * Rally points represented by items; without altitudes for a vehicle on the ground or water.
   *
   * @param home home position, for relative altitudes
   * @throws PlanRefusal naming an item that the vehicle cannot use
   */
  static List<StationPlan.Place> places(
      List<MissionItem> items, VehicleKind kind, Optional<Geodetic> home) {
    List<StationPlan.Place> places = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      MissionItem item = items.get(i);
      if (item.command() != RALLY_POINT) {
        throw refusal(i, "is a command " + item.command() + "; expected 5100, a rally point");
      }
      if (Math.abs(item.x()) > MAX_LATITUDE || Math.abs(item.y()) > MAX_LONGITUDE) {
        throw refusal(i, item.latitudeDeg() + ", " + item.longitudeDeg() + " is not on the earth");
      }
      OptionalDouble altitudeM = altitudeM(item, i, home);
      boolean flies = kind == VehicleKind.PLANE || kind == VehicleKind.COPTER;
      if (flies && home.isPresent() && altitudeM.orElse(0.0) <= home.get().altitudeM()) {
        throw refusal(i, "is not above the home's altitude");
      }
      places.add(
          new StationPlan.Place(
              item.longitudeDeg(),
              item.latitudeDeg(),
              kind.isOnSurface() ? OptionalDouble.empty() : altitudeM));
    }
    return places;
  }

  private static OptionalDouble altitudeM(MissionItem item, int index, Optional<Geodetic> home) {
    double given = Double.parseDouble(Float.toString(item.z()));
    if (!Double.isFinite(given)) {
      throw refusal(index, "has no altitude");
    }
    if (ABOVE_SEA.contains(item.frame())) {
      return OptionalDouble.of(given);
    }
    if (!ABOVE_HOME.contains(item.frame())) {
      throw refusal(
          index, "is in MAV_FRAME " + item.frame() + "; expected above sea level or above home");
    }
    if (home.isEmpty()) {
      throw refusal(index, "is relative to the home, which is not known");
    }
    return OptionalDouble.of(given + home.get().altitudeM());
  }

  private static PlanRefusal refusal(int index, String why) {
    return new PlanRefusal(
        MavMissionResult.MAV_MISSION_UNSUPPORTED, "rally point " + (index + 1) + ": " + why);
  }

  /** Items of rally points; one without an altitude gets the home's. */
  static List<MissionItem> items(List<StationPlan.Place> places) {
    List<MissionItem> items = new ArrayList<>();
    for (StationPlan.Place place : places) {
      items.add(
          new MissionItem(
              place.altitudeM().isPresent() ? 0 : 3,
              RALLY_POINT,
              1,
              0.0f,
              0.0f,
              0.0f,
              0.0f,
              (int) Math.round(place.latitudeDeg() * PER_DEGREE),
              (int) Math.round(place.longitudeDeg() * PER_DEGREE),
              (float) place.altitudeM().orElse(0.0)));
    }
    return items;
  }
}
