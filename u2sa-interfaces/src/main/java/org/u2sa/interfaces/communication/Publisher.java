package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.U2SAData;

/** Publishes messages to subscribers (thesis 3.2.1.3). */
public interface Publisher extends Configurator {
  /**
   * Announces that messages of this class will be published on the standard channel of the role.
   * Called in the constructor.
   *
   * @return whether that succeeded; if not, the reason is in the log
   */
  boolean registerPublisher(Class<? extends U2SAData> dataType);

  /** Reverts {@link #registerPublisher}. */
  boolean unregisterPublisher(Class<? extends U2SAData> dataType);

  /**
   * Freezes the message and publishes it on the channel registered for its class or nearest
   * ancestor.
   *
   * @return whether it was passed on; if not, the reason is in the log
   */
  boolean publish(U2SAData data);
}
