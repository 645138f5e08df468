package org.u2sa.service.actuator;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/**
 * Holds the latest command per actuator until it expires, so that an actuator goes neutral when
 * control is lost (as in PX4 and ArduPilot). Accepted angles, speeds and forces are also held as
 * percentages. Not thread-safe.
 */
public final class CommandHold {
  private record Held(ActuatorCommand command, double percentage, long untilMicros) {}

  private final Clock clock;
  private final String systemId;
  private final long defaultExpiryMicros;
  private final long toleranceMicros;
  private final Map<String, ActuatorExtents> actuators = new LinkedHashMap<>();
  private final Map<String, Held> newest = new LinkedHashMap<>();

  /**
   * @param systemId system ID of accepted commands
   * @param defaultExpiryS lifetime of a command without its own expiry [s], positive
   * @param toleranceS maximum lead of a command's timestamp over this clock [s]
   * @param actuators actuator names with the accepted percentages
   */
  public CommandHold(
      Clock clock,
      String systemId,
      double defaultExpiryS,
      double toleranceS,
      Map<String, Range> actuators) {
    if (!(defaultExpiryS > 0.0)) {
      throw new IllegalArgumentException("defaultExpiryS: " + defaultExpiryS + " is not positive");
    }
    this.clock = clock;
    this.systemId = systemId;
    this.defaultExpiryMicros = Clock.micros(defaultExpiryS);
    this.toleranceMicros = Clock.micros(toleranceS);
    actuators.forEach(
        (name, range) -> this.actuators.put(name, ActuatorExtents.ofPercentages(range)));
  }

  /** Accepts a command (empty), or returns the reason for refusal. */
  public Optional<CommandRefusal> accept(ActuatorCommand command) {
    ActuatorExtents extents = actuators.get(command.actuatorName());
    if (extents == null) {
      return Optional.of(CommandRefusal.NOT_ADDRESSED);
    }
    if (!command.systemId().isEmpty() && !command.systemId().equals(systemId)) {
      return Optional.of(CommandRefusal.WRONG_SYSTEM);
    }
    if (!extents.takes(command)) {
      return Optional.of(
          extents.takesOnlyPercentages()
              ? CommandRefusal.NOT_A_PERCENTAGE
              : CommandRefusal.NOT_TAKEN);
    }
    double percentage = extents.percentage(command);
    if (!extents.contains(percentage)) { // a subclass may return NaN, which no field stores
      return Optional.of(CommandRefusal.OUT_OF_RANGE);
    }
    long now = clock.micros();
    long saidMicros = command.timestamp().orElse(now);
    if (saidMicros > now + toleranceMicros) {
      return Optional.of(CommandRefusal.FROM_THE_FUTURE);
    }
    long expiryMicros =
        command.expiry().isPresent()
            ? Clock.micros(command.expiry().getAsDouble())
            : defaultExpiryMicros;
    // A timestamp ahead of this clock must not keep an actuator moving after control is gone.
    long sinceMicros = Math.min(now, saidMicros);
    long untilMicros = sinceMicros + Math.min(expiryMicros, Clock.NEVER - Math.max(0, sinceMicros));
    if (untilMicros <= now) {
      return Optional.of(CommandRefusal.TOO_OLD);
    }
    newest.put(command.actuatorName(), new Held(command, percentage, untilMicros));
    return Optional.empty();
  }

  /** Restricts the accepted commands of an actuator to its announcement. */
  public void limit(ActuatorAnnouncement announced) {
    ActuatorExtents extents = ActuatorExtents.of(announced);
    actuators.computeIfPresent(announced.actuatorName(), (name, before) -> extents);
    newest.computeIfPresent(
        announced.actuatorName(), (name, held) -> extents.contains(held.percentage) ? held : null);
  }

  /**
   * The active commands with their remaining lifetimes, for transfer to another hold, where they
   * expire at the same time.
   */
  public List<ActuatorCommand> standing() {
    long now = clock.micros();
    List<ActuatorCommand> standing = new ArrayList<>();
    newest.forEach(
        (actuator, held) -> {
          if (held.untilMicros > now) {
            ActuatorCommand command = (ActuatorCommand) held.command.copy();
            command.expiry(Clock.seconds(held.untilMicros - now));
            command.timestamp(now);
            standing.add(command);
          }
        });
    return standing;
  }

  /** Current command [%], −100…100; empty if never commanded or expired. */
  public OptionalDouble percentage(String actuator) {
    Held held = newest.get(actuator);
    return held == null || held.untilMicros <= clock.micros()
        ? OptionalDouble.empty()
        : OptionalDouble.of(held.percentage);
  }

  /** Current command as sent; empty if {@link #percentage} is. */
  public Optional<ActuatorCommand> command(String actuator) {
    Held held = newest.get(actuator);
    return held == null || held.untilMicros <= clock.micros()
        ? Optional.empty()
        : Optional.of(held.command);
  }

  public void forget() {
    newest.clear();
  }
}
