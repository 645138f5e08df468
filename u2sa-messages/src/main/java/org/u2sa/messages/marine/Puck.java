package org.u2sa.messages.marine;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.shape.Cylinder;

/** A hockey puck on the deck of a dock (thesis 4.2). */
public class Puck extends Cylinder {
  public static final MessageType<Puck> TYPE =
      Schema.of(Puck.class, Puck::new, Cylinder.TYPE).build();

  @Override
  public MessageType<? extends Puck> type() {
    return TYPE;
  }
}
