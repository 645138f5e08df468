package org.u2sa.core.safety;

import java.util.Collection;
import org.u2sa.interfaces.configuration.Configurator;

/**
 * Provides an extension's checks to every {@link SafetyManager}; loaded by {@link
 * java.util.ServiceLoader}.
 */
public interface SafetyCheckProvider {
  /**
   * Creates the checks for one Safety Manager.
   *
   * @param configuration the Safety Manager's configuration, in which checks declare and read
   *     variables
   */
  Collection<SafetyCheck> checks(Configurator configuration);
}
