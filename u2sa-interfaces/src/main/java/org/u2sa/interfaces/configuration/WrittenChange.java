package org.u2sa.interfaces.configuration;

/**
 * What came of a change: checked, and on file if it was accepted, but not yet in memory. So the
 * disk is waited for on one thread, and another sees the values change between two of its steps.
 *
 * @param outcome what is to be answered
 * @param effect has the memory follow the disk
 */
public record WrittenChange(ConfigurationOutcome outcome, Runnable effect) {
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
