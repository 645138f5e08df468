package org.u2sa.interfaces.configuration;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.contract.ConfigurationAssignment;

/**
 * What came of an attempt to change a configuration.
 *
 * @param refusal why nothing was changed; empty if all was
 * @param assignments the variables with their new and previous values; as asked for, if refused
 * @param changed names of the variables that have another value than before
 * @param revision the configuration's revision now
 */
public record ConfigurationOutcome(
    Optional<String> refusal,
    List<ConfigurationAssignment> assignments,
    Set<String> changed,
    long revision) {
  /** Whether all variables have the values that were asked for. */
  public boolean accepted() {
    return !refusal.isPresent();
  }
}
