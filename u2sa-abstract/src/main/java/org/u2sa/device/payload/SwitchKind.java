package org.u2sa.device.payload;

/**
 * Kinds of switched payloads, by their behaviour at the start, without commands, at an emergency
 * stop, while disarmed, and when the service ends.
 */
public enum SwitchKind {
  /** Unchanged: a gripper does not drop its load. */
  GRIPPER("OPEN 0, CLOSED 100"),
  /** Goes to its first position, the safe one, and leaves it through the interlock only. */
  RELEASE("LOCKED 0, RELEASED 100"),
  /** Goes to its last position: a brake engages. */
  BRAKE("RELEASED 0, ENGAGED 100"),
  /** Unchanged. */
  LIGHT("OFF 0, ON 100");

  private final String positions;

  SwitchKind(String positions) {
    this.positions = positions;
  }

  /** Usual positions, as {@link SwitchPositions} reads them. */
  String positions() {
    return positions;
  }
}
