package org.u2sa.messages;

/** Vehicle's reaction to its planned path. Names are part of the wire format; append only. */
public enum PathStatus {
  /** Follows the path. */
  FOLLOWED,
  /** Waits: there is no path at present, or traffic blocks it. */
  WAITING,
  /** Brakes, or turns as tightly as possible: a collision is imminent. */
  BRAKING,
  /** Recovers from being stuck: backs out or turns. */
  RECOVERING,
  /** No path; the goal was abandoned. */
  GIVEN_UP
}
