package org.u2sa.recorder.mcap;

import java.io.IOException;

/** Says that a file is not what the format wants, or breaks off. */
public class McapException extends IOException {
  private static final long serialVersionUID = 1L;

  /** Says what is wrong. */
  public McapException(String message) {
    super(message);
  }

  /** Says what is wrong, and what was found wrong first. */
  public McapException(String message, Throwable cause) {
    super(message, cause);
  }
}
