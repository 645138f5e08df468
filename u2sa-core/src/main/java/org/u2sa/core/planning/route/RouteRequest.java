package org.u2sa.core.planning.route;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.core.planning.curve.Pose;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.seen.PlanarShape;

/**
 * A way that is wanted. All places are on the planning plane.
 *
 * @param start where the vehicle is
 * @param goalNorthM the goal [m]
 * @param goalEastM the goal [m]
 * @param goalHeadingRad direction in which to arrive [rad, clockwise from north]; empty if it does
 *     not matter
 * @param toleranceM the goal is reached this near [m]
 * @param mobility the vehicle
 * @param costs what ways around the vehicle cost; the goal may lie outside
 * @param shapes what stands in the way, as shapes; what only a grid shows is not among them
 * @param corridors areas of which one must always be around the vehicle; empty if it may go
 *     anywhere
 * @param effort most nodes to search now, above 0; a planner that needs more answers {@link
 *     Route#sought} and goes on when it is asked for the same way again
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
    int effort) {}
