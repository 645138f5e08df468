package org.u2sa.messages.shape;

import org.u2sa.messages.PointConversion;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** An upright solid box around the centre, its height along z. */
public class Box extends ShapeSetters<Box> {
  private static final Schema<Box> SCHEMA = Schema.of(Box.class, Box::new, ShapeDescription.TYPE);
  private static final NumberField<Box> LENGTH = SCHEMA.number("length", "m", 0.0, 0.0);
  private static final NumberField<Box> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);
  private static final NumberField<Box> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);
  private static final NumberField<Box> PSI = SCHEMA.number("psi", "rad", 0.0);

  public static final MessageType<Box> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Box> type() {
    return TYPE;
  }

  /** Length, along the direction of psi [m]. */
  public double length() {
    return require(LENGTH);
  }

  public Box length(double value) {
    return put(LENGTH, value);
  }

  /** Width, across the direction of psi [m]. */
  public double width() {
    return require(WIDTH);
  }

  public Box width(double value) {
    return put(WIDTH, value);
  }

  /** Height [m], centred on z. */
  public double height() {
    return require(HEIGHT);
  }

  public Box height(double value) {
    return put(HEIGHT, value);
  }

  /** Direction of the length axis [rad], measured as the frame measures psi. */
  public double psi() {
    return require(PSI);
  }

  public Box psi(double value) {
    return put(PSI, value);
  }

  @Override
  protected void move(PointConversion conversion) {
    psi(conversion.heading(center(), psi()));
    super.move(conversion);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toBox(
        referenceFrame(), metres(from), psi(), Point.of(length(), width(), height()));
  }
}
