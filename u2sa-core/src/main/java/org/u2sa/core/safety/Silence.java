package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/** How long senders have been silent, for a successor that must miss them too. */
final class Silence {
  private static final String NAMES = " heard";
  private static final String TIMES = " silent";

  private Silence() {}

  /**
   * Writes who was heard, and for how long each has been silent.
   *
   * @param key the beginning of the values' names
   * @param heardMicros when each sender was last heard
   */
  static void handOver(HandOver state, String key, Map<String, Long> heardMicros, long nowMicros) {
    List<String> silentS = new ArrayList<>();
    heardMicros.values().forEach(at -> silentS.add(seconds(nowMicros - at)));
    state.texts(key + NAMES, heardMicros.keySet()).texts(key + TIMES, silentS);
  }

  /**
   * Returns when each sender was last heard. One that was silent for no longer than {@code sinceS}
   * counts as heard now, because it may have spoken after the state was written.
   */
  static Map<String, Long> takeOver(HandOver state, String key, long nowMicros, double sinceS) {
    List<String> names = state.texts(key + NAMES);
    List<String> silentS = state.texts(key + TIMES);
    Map<String, Long> heardMicros = new TreeMap<>();
    for (int i = 0; i < names.size(); i++) {
      double silent = Double.parseDouble(silentS.get(i));
      heardMicros.put(names.get(i), silent > sinceS ? nowMicros - Clock.micros(silent) : nowMicros);
    }
    return heardMicros;
  }

  static String seconds(long micros) {
    return Double.toString(Clock.seconds(micros));
  }
}
