package org.u2sa.device.payload;

/** Behaviour of a joint or axis without commands, at an emergency stop and while disarmed. */
public enum WithoutCommands {
  /** Moves to its neutral angle at its rate limit. */
  NEUTRAL,
  /** Keeps its angle. */
  HOLD
}
