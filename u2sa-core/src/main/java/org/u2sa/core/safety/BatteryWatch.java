package org.u2sa.core.safety;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.schema.U2SAData;

/** Whether a battery has been below a level, by voltage or charge, for long enough to mean it. */
final class BatteryWatch implements Watch {
  /** Since when which battery is below the level, and by which word of its own. */
  private record Low(long sinceMicros, String words) {}

  private final Hazard hazard;
  private final Configurator configuration;
  private final VariableDeclaration<Double> voltage;
  private final VariableDeclaration<Double> remaining;
  private final Map<String, Low> low = new TreeMap<>();
  private boolean heard;

  BatteryWatch(
      Hazard hazard,
      Configurator configuration,
      VariableDeclaration<Double> voltage,
      VariableDeclaration<Double> remaining) {
    this.hazard = hazard;
    this.configuration = configuration;
    this.voltage = voltage;
    this.remaining = remaining;
    configuration.getVariable(SafetyVariables.BATTERY_TIME);
    isConfigured();
  }

  @Override
  public Hazard hazard() {
    return hazard;
  }

  private boolean isConfigured() {
    double volts = configuration.getVariable(voltage);
    double percent = configuration.getVariable(remaining);
    return volts > 0.0 || percent > 0.0;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (!(message instanceof BatteryState battery)) {
      return;
    }
    heard = true;
    String words =
        below("voltage", battery.voltage(), voltage)
            + below("remaining", battery.remaining(), remaining);
    if (words.isEmpty()) {
      low.remove(battery.sensorName());
    } else {
      Low before = low.get(battery.sensorName());
      long since = before == null ? nowMicros : before.sinceMicros();
      low.put(battery.sensorName(), new Low(since, battery.sensorName() + words));
    }
  }

  private String below(String what, OptionalDouble value, VariableDeclaration<Double> level) {
    double least = configuration.getVariable(level);
    return value.isPresent() && value.getAsDouble() < least
        ? ", " + what + " " + value.getAsDouble() + " below " + least + " " + level.unit()
        : "";
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    long time = Clock.micros(configuration.getVariable(SafetyVariables.BATTERY_TIME));
    for (Low each : low.values()) {
      if (nowMicros - each.sinceMicros() >= time) {
        return Optional.of(each.words());
      }
    }
    return Optional.empty();
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    if (isConfigured() && !heard) {
      return Optional.of("a level is configured, but no battery was heard");
    }
    return low.values().stream().findFirst().map(Low::words);
  }
}
