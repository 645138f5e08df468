package org.u2sa.core.health;

/** Action on a failed service. The names are used in configurations. */
enum Policy {
  /** Restart it a few times, then do what AFTER RESTARTS says. */
  RESTART,
  /** Report it, and nothing else. */
  ALERT,
  /** Give it up: the Safety Manager acts at once. */
  FAILSAFE
}
