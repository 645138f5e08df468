package org.u2sa.interfaces.configuration;

/**
 * A validated change that is on file, if accepted, but not yet in memory: one thread waits for the
 * disk, and another sees the values change between two of its steps.
 *
 * @param outcome outcome to report
 * @param effect applies the change in memory
 */
public record WrittenChange(ConfigurationOutcome outcome, Runnable effect) {
  /**
   * Applies this and earlier written changes in memory, all at once and without disk access.
   * Thread-safe; further calls have no effect.
   *
   * @return {@link #outcome}
   */
  public ConfigurationOutcome takeEffect() {
    effect.run();
    return outcome;
  }
}
