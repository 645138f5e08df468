package org.u2sa.interfaces.configuration;

import java.util.Map;
import java.util.Optional;

/** Validates a combination of individually valid values. */
@FunctionalInterface
public interface ConfigurationCheck {
  /** Accepts everything. */
  ConfigurationCheck NONE = values -> Optional.empty();

  /**
   * Reason for rejection; empty if accepted.
   *
   * @param values all variables as they would be, in the declared units
   */
  Optional<String> refusal(Map<String, Object> values);
}
