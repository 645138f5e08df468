package org.u2sa.messages.schema;

import java.util.Collection;
import java.util.List;

/** An extension as the class path brings it. */
public final class TideProvider implements MessageTypeProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(EvolutionTest.Tide.TYPE);
  }
}
