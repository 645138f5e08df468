package org.u2sa.core.security;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * Role of a broker user. Determines what the user may publish, by {@link AccessTable}; everyone may
 * read.
 */
public enum AccessRole {
  /** Sensors, estimators, planners: measures, estimates, plans, and answers requests. */
  SERVICE(true),
  /** The control system: a service that commands actuators. */
  CONTROL(true),
  /** Starts and stops the services of a process, and reports the results of orders. */
  LAUNCHER(true),
  /** The health monitor: a service that judges the others and orders restarts. */
  MONITOR(true),
  /** The safety manager: a service that sets failsafes, arms, and sets the emergency stop. */
  SAFETY(true),
  /** People who command the vehicle: stop, configure, swap, arm, clear the emergency stop. */
  OPERATOR(false),
  /** Screens and recorders: discover services and read configurations, change nothing. */
  OBSERVER(false);

  private final boolean ownChannels;

  AccessRole(boolean ownChannels) {
    this.ownChannels = ownChannels;
  }

  /** Whether the role may also publish on non-standard channels. */
  public boolean mayPublishOnOwnChannels() {
    return ownChannels;
  }

  /** Name in files and on the command line. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The role of that name. */
  public static Optional<AccessRole> named(String text) {
    return Arrays.stream(values()).filter(role -> role.text().equals(text)).findFirst();
  }
}
