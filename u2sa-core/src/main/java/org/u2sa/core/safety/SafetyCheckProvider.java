package org.u2sa.core.safety;

import java.util.Collection;
import org.u2sa.interfaces.configuration.Configurator;

/**
 * Brings an extension's checks to every {@link SafetyManager}; found through {@link
 * java.util.ServiceLoader}.
 */
public interface SafetyCheckProvider {
  /**
   * New checks for one Safety Manager.
   *
   * @param configuration the Safety Manager's, from which checks declare and read variables
   */
  Collection<SafetyCheck> checks(Configurator configuration);
}
