package org.u2sa.control.fixedwing;

import java.util.Collection;
import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;

/** Registers this module's message types. */
public final class FixedWingMessages implements MessageTypeProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(ControlStatus.TYPE);
  }
}
