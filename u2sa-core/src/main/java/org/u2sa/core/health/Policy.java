package org.u2sa.core.health;

/** What to do about a service that no longer works. The names stand in configurations. */
enum Policy {
  /** Restart it a few times, then do what AFTER RESTARTS says. */
  RESTART,
  /** Report it, and nothing else. */
  ALERT,
  /** Give it up: the Safety Manager acts at once. */
  FAILSAFE
}
