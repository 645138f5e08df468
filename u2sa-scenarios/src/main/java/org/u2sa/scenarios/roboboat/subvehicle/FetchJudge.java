package org.u2sa.scenarios.roboboat.subvehicle;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Judges by the truth whether the quadrotor grips the puck, and is back on the deck before the boat
 * leaves the dock.
 */
public final class FetchJudge {
  private static final double GRIPPER_M = 0.25; // reach, level
  private static final double LOW_M = 0.4; // of the aircraft above the deck, at the puck
  private static final double GRIP_S = 1.5;
  private static final double DECK_M = 0.5; // from the boat's centre
  private static final double LANDED_M = 0.3; // of the aircraft above the deck

  private final Point puck; // east, north [m]
  private double sinceS = Double.NaN;
  private boolean isGripped;
  private boolean isBack;
  private boolean isLeft;

  /**
   * @param puck east, north [m]
   */
  public FetchJudge(Point puck) {
    this.puck = puck;
  }

  /**
   * Judges a moment.
   *
   * @param isDocked whether the boat is in the dock
   */
  public void see(VehicleTruth quadrotor, VehicleTruth boat, boolean isDocked) {
    boolean isAtPuck =
        level(quadrotor.position(), puck) < GRIPPER_M && quadrotor.position().z() < LOW_M;
    sinceS = !isAtPuck ? Double.NaN : Double.isNaN(sinceS) ? quadrotor.timeS() : sinceS;
    isGripped |= quadrotor.timeS() - sinceS >= GRIP_S;
    boolean isOnDeck =
        level(quadrotor.position(), boat.position()) < DECK_M
            && quadrotor.position().z() < LANDED_M;
    isLeft |= !isDocked && !isOnDeck && !isBack;
    isBack |= isGripped && isOnDeck && !isLeft;
  }

  private static double level(Point a, Point b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  /** Whether it gripped the puck. */
  public boolean isGripped() {
    return isGripped;
  }

  /** Whether it was back with the puck before the boat left. */
  public boolean isBack() {
    return isBack;
  }

  /** Whether the boat left without it. */
  public boolean isLeftBehind() {
    return isLeft;
  }
}
