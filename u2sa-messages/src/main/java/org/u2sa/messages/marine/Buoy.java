package org.u2sa.messages.marine;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Sphere;

/** A spherical buoy with a colour (thesis 4.2.1.1). */
public class Buoy extends Sphere {
  private static final Schema<Buoy> SCHEMA = Schema.of(Buoy.class, Buoy::new, Sphere.TYPE);
  private static final ValueField<Buoy, Colour> COLOUR =
      SCHEMA.requiredChoice("colour", Colour.class);

  public static final MessageType<Buoy> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Buoy> type() {
    return TYPE;
  }

  public Colour colour() {
    return require(COLOUR);
  }

  public Buoy colour(Colour value) {
    return put(COLOUR, value);
  }
}
