package org.u2sa.core.communication.web;

/** The broker's session of a connection, as the web port needs it. */
public interface WebSession {
  /** Whether the client has not identified itself yet. */
  boolean isPending();

  /** Whether the session has ended. */
  boolean isOut();

  /**
   * Ends the connection.
   *
   * @param why reason for the log, identical for all clients with that reason
   */
  void putOut(String why);
}
