package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.messages.safety.ManualState;

/**
 * Whether a pilot moves the actuators himself, by a radio and a multiplexer, whatever services
 * command. As long as he does, failsafes cannot help, and would surprise him when he gives back.
 */
final class SafetyPilot {
  private final Supplier<SafetyVariables> settings;
  private final Conditions conditions;
  private Optional<ManualState> newest = Optional.empty();

  SafetyPilot(Supplier<SafetyVariables> settings, Conditions conditions) {
    this.settings = settings;
    this.conditions = conditions;
  }

  void see(ManualState state) {
    newest = Optional.of(state);
  }

  /** Whether he flies, as far as a service knows that works. */
  boolean flies() {
    String service = settings.get().pilotService();
    return !service.isEmpty()
        && newest.filter(ManualState::active).isPresent()
        && conditions.failure(service).isEmpty();
  }
}
