package org.u2sa.scenarios.roboboat.subvehicle;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * The puck on the dock and the passive gripper below the quadrotor, which grips the puck after some
 * time above it. Thread-safe.
 */
public final class PuckGripper {
  private static final double REACH_M = 0.25; // horizontal
  private static final double LOW_M = 0.4; // height of the aircraft above the deck, at the puck
  private static final double GRIP_S = 1.5;
  private static final double PUCK_KG = 0.165; // official: 156 to 170 g

  private final Point puck; // east, north [m]
  private double sinceS = Double.NaN; // time of arrival at the puck
  private boolean isHolding;

  /**
   * @param puck east, north [m]
   */
  public PuckGripper(Point puck) {
    this.puck = puck;
  }

  /** Updates for the quadrotor's motion. */
  synchronized void see(VehicleTruth quadrotor) {
    Point at = quadrotor.position();
    boolean isAtPuck = Math.hypot(at.x() - puck.x(), at.y() - puck.y()) < REACH_M && at.z() < LOW_M;
    sinceS = !isAtPuck ? Double.NaN : Double.isNaN(sinceS) ? quadrotor.timeS() : sinceS;
    isHolding |= quadrotor.timeS() - sinceS >= GRIP_S;
  }

  /** Whether the gripper holds the puck. */
  synchronized boolean isHolding() {
    return isHolding;
  }

  /** Load on the gripper's load cell beyond its own weight [N]. */
  double loadN() {
    return isHolding() ? PUCK_KG * Gravity.STANDARD_MPS2 : 0.0;
  }
}
