package org.u2sa.interfaces.configuration;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Current values, and changes that are written but not yet in effect. Thread-safe; never locked
 * during disk access.
 */
final class LiveValues {
  private final ConfigurationValues values;
  private final Deque<List<ChangePlanner.PlannedChange>> waiting =
      new ArrayDeque<>(); // oldest first
  private volatile long version; // written under this

  LiveValues(ConfigurationValues values) {
    this.values = values;
  }

  String origin() {
    return values.origin();
  }

  synchronized <T> T get(Function<ConfigurationValues, T> question) {
    return question.apply(values);
  }

  synchronized void update(Consumer<ConfigurationValues> change) {
    change.accept(values);
    version++;
  }

  /** Changes whenever any value may have changed. */
  long version() {
    return version;
  }

  /** A copy with the values on file, as if all pending changes had taken effect. */
  synchronized ConfigurationValues written() {
    return withWaiting(values.copy());
  }

  synchronized LiveValues forSuccessor() {
    return new LiveValues(withWaiting(values.forSuccessor()));
  }

  private ConfigurationValues withWaiting(ConfigurationValues copy) {
    waiting.forEach(changes -> changes.forEach(copy::adopt));
    return copy;
  }

  synchronized void await(List<ChangePlanner.PlannedChange> changes) {
    waiting.add(changes);
  }

  /** Applies these and earlier changes, if still pending. */
  synchronized void takeEffect(List<ChangePlanner.PlannedChange> changes) {
    boolean isWaiting =
        waiting.stream().anyMatch(each -> each == changes); // by identity: equal ones may exist
    while (isWaiting) {
      List<ChangePlanner.PlannedChange> next = waiting.remove();
      next.forEach(values::adopt);
      isWaiting = next != changes;
      version++;
    }
  }
}
