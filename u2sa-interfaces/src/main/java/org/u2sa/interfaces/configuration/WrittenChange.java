package org.u2sa.interfaces.configuration;

/**
 * What came of a change: checked, and on file if it was accepted, but not yet in memory. So the
 * disk is waited for on one thread, and another sees the values change between two of its steps.
 */
public final class WrittenChange {
  private final ConfigurationOutcome outcome;
  private final Runnable effect;

  WrittenChange(ConfigurationOutcome outcome, Runnable effect) {
    this.outcome = outcome;
    this.effect = effect;
  }

  /** What is to be answered. */
  public ConfigurationOutcome outcome() {
    return outcome;
  }

  /**
   * Has the variables of the change, and of those written before it, take their new values: all at
   * once, without a look at the disk. From any thread; a second call has no effect.
   *
   * @return {@link #outcome}
   */
  public ConfigurationOutcome takeEffect() {
    effect.run();
    return outcome;
  }
}
