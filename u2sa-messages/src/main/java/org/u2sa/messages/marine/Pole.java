package org.u2sa.messages.marine;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Cylinder;

/** An upright coloured pole, such as a post of an underwater gate or a tall buoy. */
public class Pole extends Cylinder implements Coloured {
  private static final Schema<Pole> SCHEMA =
      Schema.of(Pole.class, Pole::new, Cylinder.TYPE).since(3);
  private static final ValueField<Pole, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Pole> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Pole> type() {
    return TYPE;
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Pole colour(Colour colour) {
    return put(COLOUR, colour);
  }

  @Override
  public Pole radius(double value) {
    return (Pole) super.radius(value);
  }

  @Override
  public Pole height(double value) {
    return (Pole) super.height(value);
  }
}
