package org.u2sa.scenarios.roboboat.subvehicle;

import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Judges by ground truth whether the quadrotor grips the puck and returns to the deck before the
 * boat leaves the dock.
 */
public final class FetchJudge {
  private static final double DECK_M = 0.5; // distance from the boat's centre
  private static final double LANDED_M = 0.3; // height of the aircraft above the deck

  private final PuckGripper gripper;
  private boolean isBack;
  private boolean isLeft;

  public FetchJudge(PuckGripper gripper) {
    this.gripper = gripper;
  }

  /**
   * Judges a moment.
   *
   * @param isDocked whether the boat is in the dock
   */
  public void see(VehicleTruth quadrotor, VehicleTruth boat, boolean isDocked) {
    gripper.see(quadrotor);
    boolean isOnDeck =
        quadrotor.position().flatDistanceTo(boat.position()) < DECK_M
            && quadrotor.position().z() < LANDED_M;
    isLeft |= !isDocked && !isOnDeck && !isBack;
    isBack |= gripper.isHolding() && isOnDeck && !isLeft;
  }

  /** Whether the quadrotor gripped the puck. */
  public boolean isGripped() {
    return gripper.isHolding();
  }

  /** Whether the quadrotor returned with the puck before the boat left. */
  public boolean isBack() {
    return isBack;
  }

  /** Whether the boat left without the quadrotor. */
  public boolean isLeftBehind() {
    return isLeft;
  }
}
