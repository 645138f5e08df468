package org.u2sa.gcs.plan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A mission in the terms of MAVLink ground stations.
 *
 * @param home planned home; empty if not given
 * @param items in order
 * @param areas the fence; empty if none
 * @param rally places to return to besides the home
 */
public record StationPlan(
    Optional<Place> home, List<PlanItem> items, List<Area> areas, List<Place> rally) {
  /** A plan without rally points. */
  public StationPlan(Optional<Place> home, List<PlanItem> items, List<Area> areas) {
    this(home, items, areas, List.of());
  }

  /**
   * A position on the earth.
   *
   * @param altitudeM above mean sea level [m]; empty if not given
   */
  public record Place(double longitudeDeg, double latitudeDeg, OptionalDouble altitudeM) {}

  /**
   * Part of a fence: a polygon, or a circle with one corner, its centre.
   *
   * @param isInclusion whether the vehicle must stay within it, rather than outside
   * @param radiusM of a circle [m]; empty for polygons
   */
  public record Area(boolean isInclusion, List<Place> corners, OptionalDouble radiusM) {
    public Area {
      corners = List.copyOf(corners);
    }
  }

  public StationPlan {
    items = List.copyOf(items);
    areas = List.copyOf(areas);
    rally = List.copyOf(rally);
  }
}
