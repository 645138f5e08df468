package org.u2sa.device.payload;

/** Where a joint or an axis goes without commands, at an emergency stop and while disarmed. */
public enum WithoutCommands {
  /** To its neutral angle, at its rate limit. */
  NEUTRAL,
  /** It stays where it is. */
  HOLD
}
