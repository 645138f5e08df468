package org.u2sa.interfaces.configuration;

import java.util.Map;
import java.util.Optional;

/** Judges values that are each allowed, but perhaps not together. */
@FunctionalInterface
public interface ConfigurationCheck {
  /** Refuses nothing. */
  ConfigurationCheck NONE = values -> Optional.empty();

  /**
   * Why the values are refused; empty if they are not.
   *
   * @param values every variable of the configuration as it would be, in the declared units
   */
  Optional<String> refusal(Map<String, Object> values);
}
