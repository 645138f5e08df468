package org.u2sa.interfaces.communication;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.U2SAData;

/** Publishes messages to subscribers (thesis 3.2.1.3). */
public interface Publisher extends Configurator {
  /**
   * Announces that messages of this class will be published on the standard channel of the
   * service's role. Called in the constructor.
   *
   * @return whether the registration succeeded; if not, or if the role has no standard channel for
   *     the class, the reason is in the log
   */
  boolean registerPublisher(Class<? extends U2SAData> dataType);

  /** Reverts {@link #registerPublisher}. */
  boolean unregisterPublisher(Class<? extends U2SAData> dataType);

  /**
   * Publishes on the channel that was registered for the message's class or its nearest ancestor.
   * The message is frozen.
   *
   * @return whether the message was passed to the Communication Manager; if not, the reason is in
   *     the log
   */
  boolean publish(U2SAData data);
}
