package org.u2sa.interfaces.configuration;

/**
 * A validated change that is on file, if accepted, but not yet in memory, so that another thread
 * can apply it between two steps.
 *
 * @param effect applies the change in memory
 */
public record WrittenChange(ConfigurationOutcome outcome, Runnable effect) {
  /** Applies this and earlier written changes in memory, atomically. Thread-safe and idempotent. */
  public ConfigurationOutcome takeEffect() {
    effect.run();
    return outcome;
  }
}
