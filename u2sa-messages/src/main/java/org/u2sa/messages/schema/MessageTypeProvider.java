package org.u2sa.messages.schema;

import java.util.Collection;

/**
 * Brings message classes of an extension to every reader (8.2.5); found through {@link
 * java.util.ServiceLoader}.
 */
public interface MessageTypeProvider {
  /** The extension's types; ancestors first or not, but all of them. */
  Collection<MessageType<?>> messageTypes();
}
