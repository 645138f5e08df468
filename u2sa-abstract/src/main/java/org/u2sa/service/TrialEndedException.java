package org.u2sa.service;

/**
 * Ends the trial construction of a service at its device. Not a failure; only launchers catch it.
 */
public final class TrialEndedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  TrialEndedException() {
    super("a trial opens no device");
  }
}
