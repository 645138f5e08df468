package org.u2sa.core.communication;

import org.u2sa.interfaces.communication.CommunicationException;

/** The broker cannot listen at its address, usually because another program does. */
public final class PortTakenException extends CommunicationException {
  private static final long serialVersionUID = 1L;

  PortTakenException(String message, Exception cause) {
    super(message, cause);
  }
}
