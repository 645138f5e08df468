package org.u2sa.planning.local;

import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;

/**
 * Determines whether a vehicle has room to turn in place, or must make room first. Once it moves to
 * make room, it continues until there is enough. Immutable.
 *
 * @param speedMps speed of the vehicle along its heading [m/s]; negative in reverse
 * @param makesRoom whether the vehicle is already making room
 */
record TurnRoom(
    CostGrid costs,
    BodyDiscs body,
    MotionLimits limits,
    Pose pose,
    double speedMps,
    boolean makesRoom) {
  /** Speed below which the vehicle counts as stopped [m/s]. */
  static final double CREEPS_MPS = 0.15;

  private static final double TIGHT = 0.75; // of the clearance, to begin making room

  /** Whether the vehicle would touch something if it turned where it stops. */
  boolean isTooNarrow() {
    return spareM() < 0.0;
  }

  /** Whether it would come clearly closer to something than routes do if it turned there. */
  boolean isTight() {
    return spareM() < (makesRoom ? 1.0 : TIGHT) * enoughM(costs, body, limits);
  }

  /** Clearance for turning in place that suffices [m]: that of routes, as far as it is known. */
  static double enoughM(CostGrid costs, BodyDiscs body, MotionLimits limits) {
    return Math.min(limits.clearanceM(), costs.inflation().reachM() - body.circleM());
  }

  /** Whether it may already turn while braking, which causes a sideways drift. */
  boolean turnsAtOnce() {
    return spareM() >= limits.slipM(Math.abs(speedMps));
  }

  /** Whether the vehicle has to stop before it moves to where there is room. */
  boolean standsFirst() {
    return Math.abs(speedMps) > CREEPS_MPS && !makesRoom;
  }

  /** Clearance for turning in place where it stops, corners included [m]; negative: too little. */
  private double spareM() {
    double stopping = Math.copySign(limits.stoppingM(Math.abs(speedMps)), speedMps);
    Pose there = pose.along(stopping, 0.0);
    return costs.distanceM(there.northM(), there.eastM()) - body.circleM();
  }
}
