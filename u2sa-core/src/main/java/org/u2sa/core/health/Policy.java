package org.u2sa.core.health;

/** What is done about a service that no longer does its work. The names stand in configurations. */
enum Policy {
  /** It is started anew, a few times; then what follows. */
  RESTART,
  /** It is said, and nothing else. */
  ALERT,
  /** It is given up: said at once as a case for the safety manager. */
  FAILSAFE
}
