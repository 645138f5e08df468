package org.u2sa.interfaces.configuration;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.contract.ConfigurationAssignment;

/**
 * Outcome of a configuration change.
 *
 * @param refusal reason for rejection; empty if accepted
 * @param assignments variables with new and previous values; as requested if rejected
 * @param changed names of variables whose value changed
 * @param revision current revision of the configuration
 */
public record ConfigurationOutcome(
    Optional<String> refusal,
    List<ConfigurationAssignment> assignments,
    Set<String> changed,
    long revision) {
  /** Whether all requested values are set. */
  public boolean accepted() {
    return !refusal.isPresent();
  }
}
