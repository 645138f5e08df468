package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.U2SAData;

/** Receives published messages (thesis 3.2.1.4). */
public interface Subscriber extends Configurator {
  /**
   * Subscribes to messages of this class and its subclasses on the standard channel of the role.
   * Called in the constructor.
   *
   * @return whether that succeeded; if not, the reason is in the log
   */
  boolean registerSubscriber(Class<? extends U2SAData> dataType);

  /** Reverts {@link #registerSubscriber}. */
  boolean unregisterSubscriber(Class<? extends U2SAData> dataType);
}
