package org.u2sa.interfaces.configuration;

import java.util.function.Supplier;

/**
 * Live values of a variables record ({@link Variable}), validated on creation. Thread-safe.
 *
 * @param <T> the record
 */
public final class Settings<T> implements Supplier<T> {
  private record Bound<T>(long version, T values) {}

  private final LiveValues live;
  private final RecordBinding<T> binding;
  private volatile Bound<T> bound;

  /**
   * @throws ConfigurationException if a value is invalid; names file, line, variable, value and
   *     expectation
   */
  Settings(LiveValues live, RecordBinding<T> binding) {
    this.live = live;
    this.binding = binding;
    live.update(values -> values.declare(binding));
    bound = bind();
  }

  /** Latest consistent values. Cheap while nothing changes. */
  @Override
  public T get() {
    Bound<T> now = bound;
    if (now.version != live.version()) {
      now = bind();
      bound = now;
    }
    return now.values;
  }

  private Bound<T> bind() {
    return live.get(values -> new Bound<>(live.version(), values.bind(binding)));
  }
}
