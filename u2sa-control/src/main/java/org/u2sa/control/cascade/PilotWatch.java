package org.u2sa.control.cascade;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.ManualState;

/**
 * Whether a pilot moves the actuators past this control, by radio and multiplexer. If the radio's
 * service falls silent, it is unknown who flies, and this control counts as flying.
 */
final class PilotWatch {
  private static final long EXPIRY_MICROS = 2 * Clock.MICROS_PER_SECOND; // four repetitions

  private final Clock clock;
  private boolean flew; // as heard last
  private long heardMicros;

  PilotWatch(Clock clock) {
    this.clock = clock;
  }

  /** Sees who drives, unless it is an answer to an order that nobody else has obeyed. */
  void see(ManualState state) {
    if (state.requestId().isEmpty()) {
      flew = state.active();
      heardMicros = clock.micros();
    }
  }

  boolean flies() {
    return flew && clock.micros() - heardMicros <= EXPIRY_MICROS;
  }
}
