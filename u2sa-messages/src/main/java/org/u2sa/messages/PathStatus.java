package org.u2sa.messages;

/** What a vehicle does with its planned way. The names travel; append only. */
public enum PathStatus {
  /** It follows the way. */
  FOLLOWED,
  /** It waits: there is no way at present, or traffic is on it. */
  WAITING,
  /** It brakes, or turns as tightly as it can: a collision is near. */
  BRAKING,
  /** It frees itself: backs out or turns. */
  RECOVERING,
  /** There is no way, and the goal was given up. */
  GIVEN_UP
}
