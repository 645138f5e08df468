package org.u2sa.core.safety;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * Checks that every known battery still reports, if a threshold is set: a battery with a silent
 * sensor may be empty. One named in BATTERIES is expected while armed, even if it has never
 * reported.
 */
final class BatterySilenceWatch implements Watch {
  private static final int MAX_BATTERIES = 256; // caps memory against spoofed batteries

  /** While disarmed: the battery may have been exchanged for one with another name. */
  private static final double FORGOTTEN_AFTER_S = 60.0;

  private final Supplier<SafetyVariables> settings;
  private final Silence silence = new Silence(Hazard.BATTERY_SENSOR.words()); // by sensor name
  private final Map<String, Long> awaitedMicros = new TreeMap<>(); // of unheard named ones

  BatterySilenceWatch(Supplier<SafetyVariables> settings) {
    this.settings = settings;
  }

  @Override
  public Hazard hazard() {
    return Hazard.BATTERY_SENSOR;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (message instanceof BatteryState battery) {
      hear(battery.sensorName(), nowMicros);
    }
  }

  private void hear(String name, long nowMicros) {
    Map<String, Long> heard = silence.heardMicros();
    if (heard.size() < MAX_BATTERIES || heard.containsKey(name)) {
      silence.hear(name, nowMicros);
    }
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    silence.handOver(state, nowMicros);
  }

  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    silence.takeOver(state, nowMicros, upToDate ? 0.0 : settings.get().batteryDeadline());
  }

  @Override
  public String saved() {
    return silence.saved();
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    List<String> unheard = CauseText.names(settings.get().batteries());
    unheard.removeAll(silence.heardMicros().keySet());
    awaitedMicros.keySet().retainAll(unheard);
    unheard.forEach(name -> awaitedMicros.putIfAbsent(name, nowMicros));
    return silent(silence.heardMicros(), nowMicros).or(() -> silent(awaitedMicros, nowMicros));
  }

  private Optional<String> silent(Map<String, Long> sinceMicros, long nowMicros) {
    SafetyVariables now = settings.get();
    List<String> chosen = CauseText.names(now.batteries());
    if (!now.watchesBatteries()) {
      return Optional.empty();
    }
    return sinceMicros.entrySet().stream()
        .filter(each -> chosen.isEmpty() || chosen.contains(each.getKey()))
        .filter(each -> Clock.seconds(nowMicros - each.getValue()) > now.batteryDeadline())
        .map(
            each ->
                each.getKey()
                    + " silent for "
                    + CauseText.seconds(Clock.seconds(nowMicros - each.getValue())))
        .findFirst();
  }

  /** Drops batteries that have long been silent, unless listed in BATTERIES. */
  @Override
  public Optional<String> objection(long nowMicros) {
    SafetyVariables now = settings.get();
    double forgottenAfterS = Math.max(FORGOTTEN_AFTER_S, now.batteryDeadline());
    List<String> chosen = CauseText.names(now.batteries());
    List.copyOf(silence.heardMicros().entrySet()).stream()
        .filter(each -> !chosen.contains(each.getKey()))
        .filter(each -> Clock.seconds(nowMicros - each.getValue()) > forgottenAfterS)
        .forEach(each -> silence.forget(each.getKey()));
    return silent(silence.heardMicros(), nowMicros); // thresholds object to a missing one
  }
}
