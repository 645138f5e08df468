package org.u2sa.planning.route;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.PlanarShape;

/**
 * A request for a path. All positions are on the planning plane.
 *
 * @param start pose of the vehicle
 * @param goalNorthM the goal [m]
 * @param goalEastM the goal [m]
 * @param goalHeadingRad direction in which to arrive [rad, clockwise from north]; empty if it does
 *     not matter
 * @param toleranceM distance within which the goal counts as reached [m]
 * @param mobility the vehicle
 * @param costs cost grid around the vehicle; the goal may lie outside
 * @param shapes obstacles as shapes, without those known only from the grid
 * @param corridors areas, one of which must always contain the vehicle; empty if unrestricted
 * @param effort maximum number of nodes to search now, above 0; a planner that needs more returns
 *     {@link Route#sought} and continues when asked for the same path again
 */
public record RouteRequest(
    Pose start,
    double goalNorthM,
    double goalEastM,
    OptionalDouble goalHeadingRad,
    double toleranceM,
    Mobility mobility,
    CostGrid costs,
    List<PlanarShape> shapes,
    List<PlanarShape> corridors,
    int effort) {

  /**
   * Shape and mobility of a vehicle for planners. Immutable.
   *
   * @param body its shape
   * @param clearanceM clearance to keep from obstacles [m]
   * @param turnRadiusM minimum turn radius at its current speed [m]; 0 if it turns in place
   * @param reverses whether it can reverse
   */
  public record Mobility(BodyDiscs body, double clearanceM, double turnRadiusM, boolean reverses) {}
}
