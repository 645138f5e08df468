package org.u2sa.messages.marine;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;

/** Registers the objects of this package, as an extension registers its own. */
public final class MarineTypes implements MessageTypeProvider {
  @Override
  public List<MessageType<?>> messageTypes() {
    return List.of(
        Buoy.TYPE, Button.TYPE, Dock.TYPE, Hoop.TYPE, HotTarget.TYPE, Puck.TYPE);
  }
}
