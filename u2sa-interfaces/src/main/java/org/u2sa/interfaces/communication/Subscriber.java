package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.U2SAData;

/** What receives messages that others broadcast (thesis 3.2.1.4). */
public interface Subscriber extends Configurator {
  /**
   * Asks for messages of this class and its subclasses on the standard channel of the service's
   * role. Called in the constructor.
   *
   * @return whether the Communication Manager took the registration; if not, or if the role has no
   *     standard channel for the class, the reason is in the log
   */
  boolean registerSubscriber(Class<? extends U2SAData> dataType);

  /** Takes {@link #registerSubscriber} back. */
  boolean unregisterSubscriber(Class<? extends U2SAData> dataType);
}
