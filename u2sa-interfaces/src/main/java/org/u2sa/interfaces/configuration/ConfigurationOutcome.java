package org.u2sa.interfaces.configuration;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.contract.ConfigurationAssignment;

/**
 * Outcome of a configuration change.
 *
 * @param refusal empty if accepted
 * @param assignments variables with new and previous values; as requested if rejected
 * @param changed names of variables whose value changed
 */
public record ConfigurationOutcome(
    Optional<String> refusal,
    List<ConfigurationAssignment> assignments,
    Set<String> changed,
    long revision) {
  public boolean accepted() {
    return !refusal.isPresent();
  }
}
