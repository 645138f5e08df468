package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/**
 * An object with a geometric shape (thesis 3.2.3.7, figure 11): one subclass per shape, around the
 * centre x, y, z.
 */
public abstract class ShapeDescription extends ObjectDescription {
  public static final MessageType<ShapeDescription> TYPE =
      Schema.ofAbstract(ShapeDescription.class, UnknownShape::new, ObjectDescription.TYPE).build();

  @Override
  public MessageType<? extends ShapeDescription> type() {
    return TYPE;
  }

  /** Placeholder for a shape unknown to the reader: only its centre is known. */
  private static final class UnknownShape extends ShapeDescription {}
}
