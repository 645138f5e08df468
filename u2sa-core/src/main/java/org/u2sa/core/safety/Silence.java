package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.handover.HandOver;

/** Silence of senders, saved for a successor that must also detect their loss. */
final class Silence {
  private static final String NAMES = " heard";
  private static final String TIMES = " silent";

  private Silence() {}

  /**
   * Saves the known sources and how long each has been silent.
   *
   * @param key the beginning of the values' names
   * @param heardMicros time of each sender's last message
   */
  static void handOver(HandOver state, String key, Map<String, Long> heardMicros, long nowMicros) {
    List<String> silentS = new ArrayList<>();
    heardMicros.values().forEach(at -> silentS.add(seconds(nowMicros - at)));
    state.texts(key + NAMES, heardMicros.keySet()).texts(key + TIMES, silentS);
  }

  /**
   * Returns the time of each sender's last message. A source silent for at most {@code sinceS}
   * counts as heard now, because it may have sent data after the state was saved.
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
