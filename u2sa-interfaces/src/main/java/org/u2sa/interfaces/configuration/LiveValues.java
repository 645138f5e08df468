package org.u2sa.interfaces.configuration;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The values that hold now, and the changes that are on file and wait to take effect. Safe from any
 * thread; nobody holds it while the disk is at work.
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

  /** Another number whenever a value may have become another. */
  long version() {
    return version;
  }

  /** A copy with the values that the file has: as they will be when all that waits took effect. */
  synchronized ConfigurationValues written() {
    return withWaiting(values.copy());
  }

  /** As {@link #written}, for a service of another class, which declares anew. */
  synchronized LiveValues forSuccessor() {
    return new LiveValues(withWaiting(values.forSuccessor()));
  }

  private ConfigurationValues withWaiting(ConfigurationValues copy) {
    waiting.forEach(changes -> changes.forEach(copy::adopt));
    return copy;
  }

  /** Takes note of changes that are on file. */
  synchronized void await(List<ChangePlanner.PlannedChange> changes) {
    waiting.add(changes);
  }

  /** Adopts these changes and those before them, unless that has happened. */
  synchronized void takeEffect(List<ChangePlanner.PlannedChange> changes) {
    boolean isWaiting = waiting.stream().anyMatch(each -> each == changes); // equal ones may be
    while (isWaiting) {
      List<ChangePlanner.PlannedChange> next = waiting.remove();
      next.forEach(values::adopt);
      isWaiting = next != changes;
      version++;
    }
  }
}
