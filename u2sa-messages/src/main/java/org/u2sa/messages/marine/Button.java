package org.u2sa.messages.marine;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.shape.Sphere;

/** A red button above the water, to be pressed by the bow (thesis 4.2). */
public class Button extends Sphere {
  public static final MessageType<Button> TYPE =
      Schema.of(Button.class, Button::new, Sphere.TYPE).build();

  @Override
  public MessageType<? extends Button> type() {
    return TYPE;
  }
}
