package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.seen.PlanarShape;

/**
 * The vehicle's surroundings as known to the planner, for the {@link PlannerState}s of extensions.
 * Confined to the planner's thread.
 */
public interface PlannerView {
  /**
   * Step of an approach.
   *
   * @param point next navigation point
   * @param givenUp why the position cannot be reached; empty while it may be reachable
   */
  record Step(NavigationPoint point, Optional<String> givenUp) {}

  /** Newest objects of the World Modeler, in their own frames; empty before the first. */
  List<ObjectDescription> objects();

  /** Position of the vehicle on the planner's plane: north, east, down [m]. */
  Point here(StateInformation state);

  /**
   * Position of an object's centre on the planner's plane: north, east, down [m].
   *
   * @throws IllegalArgumentException if the object is on the earth and the plane is not, or the
   *     reverse
   */
  Point centre(ObjectDescription object, StateInformation state);

  /**
   * Outlines of the newest {@link #objects}, in their order, on the planner's plane, including
   * those that the planner does not avoid.
   */
  List<PlanarShape> outlines(StateInformation state);

  /** Course over ground, or heading at low speed [rad, clockwise from north]. */
  double courseRad(StateInformation state);

  /**
   * Position on the planner's plane: north, east, down [m].
   *
   * @param frame GLOBAL, LOCAL_NED or LOCAL_ENU
   * @throws IllegalArgumentException if the frame cannot be mapped to the plane
   */
  Point onPlane(ReferenceFrame frame, Point point, StateInformation state);

  /** Navigation point straight to a position on the planner's plane, regardless of obstacles. */
  NavigationPoint straight(StateInformation state, Point place);

  /** Time since the start of the mission [s], the time base of goals. */
  double missionS();

  /** Starts an approach to another position. */
  void begin();

  /**
   * Plans the next step to a position, around obstacles if the planner avoids any.
   *
   * @param pursuit the planner's input
   * @param place on the planner's plane: north, east, down [m]
   * @param thresholdM distance at which it counts as reached [m]
   * @param speedMps speed on the way [m/s]; empty: the planner's
   */
  Step towards(Pursuit pursuit, Point place, double thresholdM, OptionalDouble speedMps);
}
