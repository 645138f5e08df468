package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/**
 * An object described by geometry (thesis 3.2.3.7, figure 11): a subclass for each shape, around
 * the centre x, y, z.
 */
public abstract class ShapeDescription extends ObjectDescription {
  /** The schema. */
  public static final MessageType<ShapeDescription> TYPE =
      Schema.ofAbstract(ShapeDescription.class, UnknownShape::new, ObjectDescription.TYPE).build();

  @Override
  public MessageType<? extends ShapeDescription> type() {
    return TYPE;
  }

  /** Stands for a shape that the reader does not know: only its centre is certain. */
  private static final class UnknownShape extends ShapeDescription {}
}
