package org.u2sa.service;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.Clock;
import org.u2sa.messages.ActuatorCommand;
import org.u2sa.messages.PercentageCommand;

/**
 * The newest percentage command of each of some actuators, for as long as it holds: a command that
 * nobody renews expires, so that an actuator falls back to neutral when control is gone (PX4 and
 * ArduPilot do the same at their outputs).
 *
 * <p>Not safe for several threads: it belongs to the service that owns the actuators.
 */
public final class CommandHold {
  private record Held(double percentage, long untilMicros) {}

  private final Clock clock;
  private final long defaultExpiryMicros;
  private final Set<String> actuators;
  private final Map<String, Held> newest = new LinkedHashMap<>();
  private long refused;

  /**
   * @param clock what commands are timed with
   * @param defaultExpiryS how long a command holds that does not say so itself [s], positive
   * @param actuators the names to which commands are addressed
   */
  public CommandHold(Clock clock, double defaultExpiryS, Set<String> actuators) {
    if (!(defaultExpiryS > 0.0)) {
      throw new IllegalArgumentException("defaultExpiryS: " + defaultExpiryS + " is not positive");
    }
    this.clock = clock;
    this.defaultExpiryMicros = Clock.micros(defaultExpiryS);
    this.actuators = Set.copyOf(actuators);
  }

  /**
   * Takes a command if it is addressed to one of the actuators and has not expired on its way;
   * otherwise counts it as refused, unless it is simply for someone else.
   *
   * @return whether it was taken
   */
  public boolean accept(ActuatorCommand command) {
    if (!actuators.contains(command.actuatorName())) {
      return false;
    }
    long now = clock.micros();
    long expiryMicros =
        command.expiry().isPresent()
            ? Clock.micros(command.expiry().getAsDouble())
            : defaultExpiryMicros;
    // A timestamp ahead of this clock must not keep an actuator moving after control is gone.
    long sinceMicros = Math.min(now, command.timestamp().orElse(now));
    long untilMicros = sinceMicros + Math.min(expiryMicros, Clock.NEVER - Math.max(0, sinceMicros));
    if (!(command instanceof PercentageCommand percentage) || untilMicros <= now) {
      refused++;
      return false;
    }
    newest.put(command.actuatorName(), new Held(percentage.percentage(), untilMicros));
    return true;
  }

  /**
   * The percentage that the actuator should hold now, −100…100; empty if it was never commanded or
   * the command expired.
   */
  public OptionalDouble percentage(String actuator) {
    Held held = newest.get(actuator);
    return held == null || held.untilMicros <= clock.micros()
        ? OptionalDouble.empty()
        : OptionalDouble.of(held.percentage);
  }

  /** Commands for these actuators that came too late or were not percentages, so far. */
  public long refused() {
    return refused;
  }
}
