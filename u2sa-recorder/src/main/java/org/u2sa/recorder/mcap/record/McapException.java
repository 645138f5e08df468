package org.u2sa.recorder.mcap.record;

import java.io.IOException;

/** Thrown if a file violates the format or is truncated. */
public class McapException extends IOException {
  private static final long serialVersionUID = 1L;

  /** Creates an exception with a message. */
  public McapException(String message) {
    super(message);
  }

  public McapException(String message, Throwable cause) {
    super(message, cause);
  }
}
