package org.u2sa.interfaces.configuration;

import java.util.function.Supplier;

/**
 * The variables of a record ({@link Variable}) as they are at the moment: checked once, when this
 * is made, and live. Any thread may ask.
 *
 * @param <T> the record
 */
public final class Settings<T> implements Supplier<T> {
  /** The values of one version of the configuration. */
  private record Bound<T>(long version, T values) {}

  private final LiveValues live;
  private final RecordBinding<T> binding;
  private volatile Bound<T> bound;

  /**
   * @throws ConfigurationException if a value is refused; names file, line, variable, value and
   *     what was expected
   */
  Settings(LiveValues live, RecordBinding<T> binding) {
    this.live = live;
    this.binding = binding;
    live.update(values -> values.declare(binding));
    bound = bind();
  }

  /** The newest values, all of the same moment. Costs next to nothing while none changes. */
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
