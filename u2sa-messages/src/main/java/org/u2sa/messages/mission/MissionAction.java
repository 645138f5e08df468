package org.u2sa.messages.mission;

/** Operator's order to a mission. The order is part of the wire format. */
public enum MissionAction {
  /** Pursue a goal now; the mission continues from there. */
  GOTO,
  /** End a current goal and continue as if it had been completed. */
  SKIP,
  /** Add goals. */
  INSERT,
  /** Change fields of existing goals. */
  UPDATE,
  /** Continue a paused mission; otherwise return to the interrupted goal. */
  RESUME,
  /** Hold position, or circle if the vehicle cannot stop, until RESUME or GOTO. */
  PAUSE,
  /** Replace all goals; without {@code now} the new mission begins paused. */
  REPLACE,
  /** Pursue the goals of the landing instead of the current ones; RESUME returns to those. */
  LAND,
  /** Go to the home or a rally point, whichever is nearest; RESUME returns to the mission. */
  RETURN
}
