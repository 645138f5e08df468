package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/** Checks whether a battery has been below a voltage or charge threshold for BATTERY TIME. */
final class BatteryWatch implements Watch {
  private static final int MAX_LOW = 256; // so that invented batteries do not fill the memory

  /** Start time and description of a battery's undershoot. */
  private record Low(long sinceMicros, String words) {}

  private final Hazard hazard;
  private final Supplier<SafetyVariables> settings;
  private final ToDoubleFunction<SafetyVariables> leastVolts;
  private final ToDoubleFunction<SafetyVariables> leastPercent;
  private final Map<String, Low> low = new TreeMap<>();
  private final Set<String> chosenHeard = new TreeSet<>(); // batteries named in the settings
  private boolean heard; // any that counts

  private BatteryWatch(
      Hazard hazard,
      Supplier<SafetyVariables> settings,
      ToDoubleFunction<SafetyVariables> leastVolts,
      ToDoubleFunction<SafetyVariables> leastPercent) {
    this.hazard = hazard;
    this.settings = settings;
    this.leastVolts = leastVolts;
    this.leastPercent = leastPercent;
  }

  static BatteryWatch low(Supplier<SafetyVariables> settings) {
    return new BatteryWatch(
        Hazard.LOW_BATTERY,
        settings,
        SafetyVariables::lowBatteryVoltage,
        SafetyVariables::lowBatteryRemaining);
  }

  static BatteryWatch critical(Supplier<SafetyVariables> settings) {
    return new BatteryWatch(
        Hazard.CRITICAL_BATTERY,
        settings,
        SafetyVariables::criticalBatteryVoltage,
        SafetyVariables::criticalBatteryRemaining);
  }

  @Override
  public Hazard hazard() {
    return hazard;
  }

  private boolean isConfigured() {
    SafetyVariables now = settings.get();
    return leastVolts.applyAsDouble(now) > 0.0 || leastPercent.applyAsDouble(now) > 0.0;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (!(message instanceof BatteryState battery) || !counts(battery.sensorName())) {
      return;
    }
    heard = true;
    if (!chosen().isEmpty()) {
      chosenHeard.add(battery.sensorName());
    }
    String words =
        below("voltage", battery.voltage(), leastVolts, "V")
            + below("remaining", battery.remaining(), leastPercent, "%");
    if (words.isEmpty()) {
      low.remove(battery.sensorName());
    } else if (low.size() < MAX_LOW || low.containsKey(battery.sensorName())) {
      Low before = low.get(battery.sensorName());
      long since = before == null ? nowMicros : before.sinceMicros();
      low.put(battery.sensorName(), new Low(since, battery.sensorName() + words));
    }
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    List<String> values = new ArrayList<>();
    low.forEach(
        (name, each) ->
            values.addAll(
                List.of(name, Silence.seconds(nowMicros - each.sinceMicros()), each.words())));
    state.texts(hazard.words(), values);
  }

  /** A battery stays low until it reports otherwise. */
  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    List<String> values = state.texts(hazard.words());
    for (int i = 0; i + 2 < values.size(); i += 3) {
      long since = nowMicros - Clock.micros(Double.parseDouble(values.get(i + 1)));
      low.put(values.get(i), new Low(since, values.get(i + 2)));
    }
  }

  @Override
  public String saved() {
    return low.keySet().toString();
  }

  private List<String> chosen() {
    return CauseText.names(settings.get().batteries());
  }

  private boolean counts(String name) {
    List<String> chosen = chosen();
    return chosen.isEmpty() || chosen.contains(name);
  }

  private String below(
      String what, OptionalDouble value, ToDoubleFunction<SafetyVariables> level, String unit) {
    double least = level.applyAsDouble(settings.get());
    return value.isPresent() && value.getAsDouble() < least
        ? ", " + what + " " + CauseText.below(value.getAsDouble()) + " below " + least + " " + unit
        : "";
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    long time = Clock.micros(settings.get().batteryTime());
    return low.entrySet().stream()
        .filter(each -> counts(each.getKey()))
        .map(Map.Entry::getValue)
        .filter(each -> nowMicros - each.sinceMicros() >= time)
        .map(Low::words)
        .findFirst();
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    List<String> missing = chosen();
    missing.removeAll(chosenHeard);
    if (isConfigured() && !missing.isEmpty()) {
      return Optional.of("not heard: " + String.join(", ", missing));
    }
    if (isConfigured() && !heard) {
      return Optional.of("a threshold is set, but no battery heard");
    }
    return low.entrySet().stream()
        .filter(each -> counts(each.getKey()))
        .findFirst()
        .map(each -> each.getValue().words());
  }
}
