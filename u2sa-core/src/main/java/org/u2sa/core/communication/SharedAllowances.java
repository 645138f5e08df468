package org.u2sa.core.communication;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One {@link Allowance} for each user, whatever number of connections the user has. Safe for
 * several threads.
 */
final class SharedAllowances {
  private static final int USERS_REMEMBERED = 1_024;

  private final double perS;
  private final Map<String, Allowance> byUser = // guarded by this
      new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Allowance> eldest) {
          return size() > USERS_REMEMBERED;
        }
      };

  SharedAllowances(double perS) {
    this.perS = perS;
  }

  /** Takes one of the user's allowance if there is any left. */
  synchronized boolean take(String user, long nowMicros) {
    Allowance allowance = byUser.computeIfAbsent(user, name -> new Allowance(perS, nowMicros));
    if (!allowance.isOpen(nowMicros)) {
      return false;
    }
    allowance.take(1.0);
    return true;
  }
}
