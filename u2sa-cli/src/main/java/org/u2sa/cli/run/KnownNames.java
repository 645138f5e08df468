package org.u2sa.cli.run;

import java.util.Optional;
import java.util.Set;
import org.u2sa.core.health.HealthMonitor;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Service names derived from the system's files, so that no message needs to be trusted. */
final class KnownNames {
  /** Classes whose default service name is their simple name. */
  private static final Set<String> NAMED_AS_THEIR_CLASS =
      Set.of(HealthMonitor.class.getName(), SafetyManager.class.getName());

  private final LaunchOptions options;

  KnownNames(LaunchOptions options) {
    this.options = options;
  }

  /** Whether the entry's service is a health monitor; that class has no subclasses. */
  static boolean isMonitor(SystemFile.Entry entry) {
    return entry.className().equals(HealthMonitor.class.getName());
  }

  /** Returns the name that the entry's service will have, unless only the service knows it. */
  Optional<String> of(SystemFile.Entry entry) {
    String configured = configured(entry);
    if (!configured.isEmpty()) {
      return Optional.of(configured);
    }
    return NAMED_AS_THEIR_CLASS.contains(entry.className())
        ? Optional.of(entry.simpleName())
        : Optional.empty();
  }

  private String configured(SystemFile.Entry entry) {
    try {
      return options.configuration(entry).settings(Name.class).get().serviceName();
    } catch (ConfigurationException e) {
      return ""; // its process will reject it, giving the reason
    }
  }

  /** The one variable of a service that matters here. */
  record Name(
      @Variable(ifAbsentText = "") @Description("Name of the service.") String serviceName) {}
}
