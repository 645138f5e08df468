package org.u2sa.core.health;

/** Action on a failed service. The names are used in configurations. */
enum Policy {
  /** Restart the service a few times, then apply AFTER RESTARTS. */
  RESTART,
  /** Only report it. */
  ALERT,
  /** Give it up: the Safety Manager acts immediately. */
  FAILSAFE
}
