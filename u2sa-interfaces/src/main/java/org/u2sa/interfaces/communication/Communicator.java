package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.configuration.Configurator;

/** Opens a service's communication (thesis 3.2.1.2). */
public interface Communicator extends Configurator {
  /**
   * Connects to the Communication Manager; registering and publishing do so automatically.
   *
   * @return whether that succeeded; if not, the reason is in the log
   */
  boolean beginCommunication();
}
