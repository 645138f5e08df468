package org.u2sa.messages.marine;

import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.PointConversion;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A berth of a dock; x, y, z is the middle of its water, psi the heading of a boat that enters. */
public class Dock extends ObjectDescription {
  private static final Schema<Dock> SCHEMA =
      Schema.of(Dock.class, Dock::new, ObjectDescription.TYPE);
  private static final NumberField<Dock> PSI = SCHEMA.number("psi", "rad", 0.0);
  private static final NumberField<Dock> LENGTH = SCHEMA.number("length", "m", 0.0, 0.0);
  private static final NumberField<Dock> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);

  public static final MessageType<Dock> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Dock> type() {
    return TYPE;
  }

  /** Heading of a boat that enters [rad], measured as the frame measures psi. */
  public double psi() {
    return require(PSI);
  }

  public Dock psi(double value) {
    return put(PSI, value);
  }

  /** Length of the berth along psi [m]. */
  public double length() {
    return require(LENGTH);
  }

  public Dock length(double value) {
    return put(LENGTH, value);
  }

  /** Clear width of the berth [m]. */
  public double width() {
    return require(WIDTH);
  }

  public Dock width(double value) {
    return put(WIDTH, value);
  }

  @Override
  protected void move(PointConversion conversion) {
    psi(conversion.heading(center(), psi()));
    super.move(conversion);
  }
}
