package org.u2sa.messages.contract;

/** What an operator orders of a mission. The order is that of the wire. */
public enum MissionAction {
  /** Pursue a goal now; the mission goes on from there. */
  GOTO,
  /** End a current goal, and go on as if it were done. */
  SKIP,
  /** Add goals. */
  INSERT,
  /** Change fields of goals that are known. */
  UPDATE,
  /** Go on with a paused mission, or else back to where the mission was left. */
  RESUME,
  /** Stand, or circle if the vehicle cannot stand, until RESUME or GOTO. */
  PAUSE
}
