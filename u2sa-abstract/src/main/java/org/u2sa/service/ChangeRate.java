package org.u2sa.service;

import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/**
 * How often a service's configuration may be changed: some changes at once, then so many a second,
 * for each author and for all together. Authors say their names themselves, so the sum counts.
 */
final class ChangeRate {
  private static final int AUTHORS = 64; // that are told apart
  private static final double EACH_AT_ONCE = 40;
  private static final double EACH_PER_S = 10;
  private static final double ALL_AT_ONCE = 80;
  private static final double ALL_PER_S = 20;

  private final Map<String, Allowance> authors =
      new LinkedHashMap<>(AUTHORS, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Allowance> eldest) {
          return size() > AUTHORS;
        }
      };
  private final Allowance all = new Allowance(ALL_AT_ONCE, ALL_PER_S);

  /** What is left of an allowance that fills up with time. */
  private static final class Allowance {
    private final double most;
    private final double perS;
    private double left;
    private long atMicros;

    Allowance(double most, double perS) {
      this.most = most;
      this.perS = perS;
      left = most;
    }

    boolean hasOne(long nowMicros) {
      left = Math.min(most, left + Clock.seconds(Math.max(0, nowMicros - atMicros)) * perS);
      atMicros = nowMicros;
      return left >= 1.0;
    }
  }

  /**
   * Whether the author may ask for one more change; counts it if so.
   *
   * @param nowMicros time of the run's clock [µs]
   */
  boolean allows(String author, long nowMicros) {
    Allowance own =
        authors.computeIfAbsent(author, name -> new Allowance(EACH_AT_ONCE, EACH_PER_S));
    boolean allowed = own.hasOne(nowMicros) & all.hasOne(nowMicros);
    if (allowed) {
      own.left--;
      all.left--;
    }
    return allowed;
  }
}
