package org.u2sa.messages.marine;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Sphere;

/** A buoy: a sphere with a colour (thesis 4.2.1.1). */
public class Buoy extends Sphere implements Coloured {
  private static final Schema<Buoy> SCHEMA = Schema.of(Buoy.class, Buoy::new, Sphere.TYPE).since(3);
  private static final ValueField<Buoy, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Buoy> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Buoy> type() {
    return TYPE;
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Buoy colour(Colour colour) {
    return put(COLOUR, colour);
  }

  @Override
  public Buoy radius(double value) {
    return (Buoy) super.radius(value);
  }
}
