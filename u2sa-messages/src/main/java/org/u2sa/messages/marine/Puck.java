package org.u2sa.messages.marine;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Cylinder;

/**
 * A hockey puck lying on a dock (thesis 4.2.1.3); official size: radius 0.0381 m, height 0.0254 m.
 */
public class Puck extends Cylinder implements Coloured {
  private static final Schema<Puck> SCHEMA =
      Schema.of(Puck.class, Puck::new, Cylinder.TYPE).since(3);
  private static final ValueField<Puck, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Puck> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Puck> type() {
    return TYPE;
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Puck colour(Colour colour) {
    return put(COLOUR, colour);
  }

  @Override
  public Puck radius(double value) {
    return (Puck) super.radius(value);
  }

  @Override
  public Puck height(double value) {
    return (Puck) super.height(value);
  }
}
