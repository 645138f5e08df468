package org.u2sa.messages.marine;

import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.PointConversion;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** An upright ring with a colour, to be shot through; x, y, z is its centre (thesis 4.2, 4.3). */
public class Hoop extends ObjectDescription {
  private static final Schema<Hoop> SCHEMA =
      Schema.of(Hoop.class, Hoop::new, ObjectDescription.TYPE);
  private static final ValueField<Hoop, Colour> COLOUR =
      SCHEMA.requiredChoice("colour", Colour.class);
  private static final NumberField<Hoop> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);
  private static final NumberField<Hoop> PSI = SCHEMA.number("psi", "rad", 0.0);

  public static final MessageType<Hoop> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Hoop> type() {
    return TYPE;
  }

  public Colour colour() {
    return require(COLOUR);
  }

  public Hoop colour(Colour value) {
    return put(COLOUR, value);
  }

  /** Inner radius [m]; defaults to 0. */
  public double radius() {
    return require(RADIUS);
  }

  public Hoop radius(double value) {
    return put(RADIUS, value);
  }

  /** Direction in which a shot passes through [rad], measured as the frame measures psi. */
  public double psi() {
    return require(PSI);
  }

  public Hoop psi(double value) {
    return put(PSI, value);
  }

  @Override
  protected void move(PointConversion conversion) {
    psi(conversion.heading(center(), psi()));
    super.move(conversion);
  }
}
