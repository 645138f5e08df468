package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/** Silence of senders, saved for a successor that must also detect their loss. */
final class Silence {
  private static final String NAMES = " heard";
  private static final String TIMES = " silent";
  private static final String ASSUMED = " assumed";

  private final String key;
  private final Map<String, Long> heardMicros = new TreeMap<>(); // local clock, at the last message
  private final Set<String> assumed = new TreeSet<>(); // not heard since a restart

  /**
   * @param key the beginning of the saved values' names
   */
  Silence(String key) {
    this.key = key;
  }

  void hear(String who, long nowMicros) {
    heardMicros.put(who, nowMicros);
    assumed.remove(who);
  }

  void forget(String who) {
    heardMicros.remove(who);
    assumed.remove(who);
  }

  /** Time of each sender's last message; a view. */
  Map<String, Long> heardMicros() {
    return heardMicros;
  }

  /** Saves the known senders and how long each has been silent. */
  void handOver(HandOver state, long nowMicros) {
    List<String> silentS = new ArrayList<>();
    heardMicros.values().forEach(at -> silentS.add(seconds(nowMicros - at)));
    state.texts(key + NAMES, heardMicros.keySet()).texts(key + TIMES, silentS);
    state.texts(key + ASSUMED, assumed);
  }

  /**
   * Restores what was saved. A sender silent for at most {@code sinceS} counts as heard now,
   * because it may have sent data after the state was saved; but only once, or repeated restarts
   * would hide its loss.
   */
  void takeOver(HandOver state, long nowMicros, double sinceS) {
    List<String> names = state.texts(key + NAMES);
    List<String> silentS = state.texts(key + TIMES);
    List<String> before = state.texts(key + ASSUMED);
    double ageS = state.ageS(Clock.seconds(nowMicros));
    for (int i = 0; i < names.size(); i++) {
      String who = names.get(i);
      double silent = Double.parseDouble(silentS.get(i));
      boolean wasAssumed = before.contains(who);
      boolean mayHaveSent = silent <= sinceS && !wasAssumed;
      double since = mayHaveSent ? 0.0 : wasAssumed ? silent + ageS : silent;
      heardMicros.put(who, nowMicros - Clock.micros(since));
      if (mayHaveSent || wasAssumed) {
        assumed.add(who);
      }
    }
  }

  /** Whether a sender has not been heard since the restart. */
  boolean isAssumed(String who) {
    return assumed.contains(who);
  }

  /** The part of the state that must be saved whenever it changes. */
  String saved() {
    return heardMicros.keySet().toString() + assumed;
  }

  static String seconds(long micros) {
    return Double.toString(Clock.seconds(micros));
  }
}
