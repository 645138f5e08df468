package org.u2sa.core.safety;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.schema.U2SAData;

/** Checks whether a battery has been below a voltage or charge threshold for BATTERY TIME. */
final class BatteryWatch implements Watch {
  /** Start time and description of a battery's undershoot. */
  private record Low(long sinceMicros, String words) {}

  private final Hazard hazard;
  private final Supplier<SafetySettings> settings;
  private final ToDoubleFunction<SafetySettings> leastVolts;
  private final ToDoubleFunction<SafetySettings> leastPercent;
  private final Map<String, Low> low = new TreeMap<>();
  private boolean heard;

  private BatteryWatch(
      Hazard hazard,
      Supplier<SafetySettings> settings,
      ToDoubleFunction<SafetySettings> leastVolts,
      ToDoubleFunction<SafetySettings> leastPercent) {
    this.hazard = hazard;
    this.settings = settings;
    this.leastVolts = leastVolts;
    this.leastPercent = leastPercent;
  }

  static BatteryWatch low(Supplier<SafetySettings> settings) {
    return new BatteryWatch(
        Hazard.LOW_BATTERY,
        settings,
        SafetySettings::lowBatteryVoltage,
        SafetySettings::lowBatteryRemaining);
  }

  static BatteryWatch critical(Supplier<SafetySettings> settings) {
    return new BatteryWatch(
        Hazard.CRITICAL_BATTERY,
        settings,
        SafetySettings::criticalBatteryVoltage,
        SafetySettings::criticalBatteryRemaining);
  }

  @Override
  public Hazard hazard() {
    return hazard;
  }

  private boolean isConfigured() {
    SafetySettings now = settings.get();
    return leastVolts.applyAsDouble(now) > 0.0 || leastPercent.applyAsDouble(now) > 0.0;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (!(message instanceof BatteryState battery)) {
      return;
    }
    heard = true;
    String words =
        below("voltage", battery.voltage(), leastVolts, "V")
            + below("remaining", battery.remaining(), leastPercent, "%");
    if (words.isEmpty()) {
      low.remove(battery.sensorName());
    } else {
      Low before = low.get(battery.sensorName());
      long since = before == null ? nowMicros : before.sinceMicros();
      low.put(battery.sensorName(), new Low(since, battery.sensorName() + words));
    }
  }

  private String below(
      String what, OptionalDouble value, ToDoubleFunction<SafetySettings> level, String unit) {
    double least = level.applyAsDouble(settings.get());
    return value.isPresent() && value.getAsDouble() < least
        ? ", " + what + " " + value.getAsDouble() + " below " + least + " " + unit
        : "";
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    long time = Clock.micros(settings.get().batteryTime());
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
      return Optional.of("a threshold is set, but no battery heard");
    }
    return low.values().stream().findFirst().map(Low::words);
  }
}
