package org.u2sa.scenarios.roboboat.subvehicle;

import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Judges by the truth whether the quadrotor grips the puck, and is back on the deck before the boat
 * leaves the dock.
 */
public final class FetchJudge {
  private static final double DECK_M = 0.5; // from the boat's centre
  private static final double LANDED_M = 0.3; // of the aircraft above the deck

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

  /** Whether it gripped the puck. */
  public boolean isGripped() {
    return gripper.isHolding();
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
