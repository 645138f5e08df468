package org.u2sa.messages.schema;

import java.util.Collection;

/**
 * Registers message classes of an extension with every reader (8.2.5); found by {@link
 * java.util.ServiceLoader}.
 */
public interface MessageTypeProvider {
  /** All types of the extension, in any order. */
  Collection<MessageType<?>> messageTypes();
}
