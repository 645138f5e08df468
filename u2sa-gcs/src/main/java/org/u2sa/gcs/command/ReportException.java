package org.u2sa.gcs.command;

/**
 * A file of a report cannot be written: disk full, no permission. The message names the path and
 * the system's reason.
 */
public final class ReportException extends RunFailedException {

  private static final long serialVersionUID = 1L;

  public ReportException(String message, Throwable cause) {
    super(message, cause);
  }
}
