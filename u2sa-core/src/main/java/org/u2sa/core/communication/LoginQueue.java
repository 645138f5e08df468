package org.u2sa.core.communication;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Those who wait for their password to be checked: first who comes from an address without wrong
 * ones, in the order in which they came. Safe for several threads.
 */
final class LoginQueue {
  private static final int AT_MOST = 256;
  private static final int OF_ONE_ADDRESS = 8;

  private final LoginFailures failures;
  private final List<LoginApplication> waiting = new ArrayList<>(); // guarded by this

  LoginQueue(LoginFailures failures) {
    this.failures = failures;
  }

  /**
   * Adds one. Returns who has no place, perhaps the one itself: one from the address with most
   * wrong passwords, and of such with most that wait.
   */
  synchronized Optional<LoginApplication> add(LoginApplication application) {
    long same = waiting.stream().filter(other -> other.from().equals(application.from())).count();
    if (same >= OF_ONE_ADDRESS) {
      return Optional.of(application);
    }
    waiting.add(application);
    if (waiting.size() <= AT_MOST) {
      return Optional.empty();
    }
    Map<String, Integer> places = new HashMap<>();
    waiting.forEach(other -> places.merge(other.from(), 1, Integer::sum));
    LoginApplication worst =
        waiting.stream()
            .max(
                Comparator.<LoginApplication>comparingInt(failures::from)
                    .thenComparingInt(other -> places.get(other.from())))
            .orElseThrow();
    waiting.remove(worst);
    return Optional.of(worst);
  }

  /**
   * Takes the next one.
   *
   * @param blamelessOnly whether only those from an address without wrong passwords are to be taken
   */
  synchronized Optional<LoginApplication> poll(boolean blamelessOnly) {
    Optional<LoginApplication> next =
        waiting.stream().min(Comparator.comparingInt(failures::from)); // of equals the oldest
    if (next.isEmpty() || blamelessOnly && failures.from(next.get()) > 0) {
      return Optional.empty();
    }
    waiting.remove(next.get());
    return next;
  }
}
