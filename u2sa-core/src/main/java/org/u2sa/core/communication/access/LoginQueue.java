package org.u2sa.core.communication.access;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Login requests waiting for their password check, in order of arrival; addresses without wrong
 * passwords have priority. Thread-safe.
 */
public final class LoginQueue {
  private static final int AT_MOST = 256;
  private static final int OF_ONE_ADDRESS = 8;

  private final LoginFailures failures;
  private final List<LoginApplication> waiting = new ArrayList<>(); // guarded by this

  /** Creates an empty queue, which prefers requests without earlier failures. */
  public LoginQueue(LoginFailures failures) {
    this.failures = failures;
  }

  /**
   * Adds a request. Returns the displaced request, which may be the given one: it comes from the
   * address with the most wrong passwords, or on a tie with the most waiting requests.
   */
  public synchronized Optional<LoginApplication> add(LoginApplication application) {
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
   * Takes the next request.
   *
   * @param blamelessOnly whether to consider only addresses without wrong passwords
   */
  public synchronized Optional<LoginApplication> poll(boolean blamelessOnly) {
    Optional<LoginApplication> next =
        waiting.stream().min(Comparator.comparingInt(failures::from)); // the oldest on ties
    if (next.isEmpty() || blamelessOnly && failures.from(next.get()) > 0) {
      return Optional.empty();
    }
    waiting.remove(next.get());
    return next;
  }
}
