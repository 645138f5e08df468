package org.u2sa.messages.shape;

import org.u2sa.messages.PointConversion;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A rectangle in the x-y plane around the centre. */
public class Rectangle extends ShapeSetters<Rectangle> {
  private static final Schema<Rectangle> SCHEMA =
      Schema.of(Rectangle.class, Rectangle::new, ShapeDescription.TYPE);
  private static final NumberField<Rectangle> LENGTH = SCHEMA.number("length", "m", 0.0, 0.0);
  private static final NumberField<Rectangle> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);
  private static final NumberField<Rectangle> PSI = SCHEMA.number("psi", "rad", 0.0);

  public static final MessageType<Rectangle> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Rectangle> type() {
    return TYPE;
  }

  /** Length, along the direction of psi [m]. */
  public double length() {
    return require(LENGTH);
  }

  public Rectangle length(double value) {
    return put(LENGTH, value);
  }

  /** Width, across the direction of psi [m]. */
  public double width() {
    return require(WIDTH);
  }

  public Rectangle width(double value) {
    return put(WIDTH, value);
  }

  /** Direction of the length axis [rad], measured as the frame measures psi. */
  public double psi() {
    return require(PSI);
  }

  public Rectangle psi(double value) {
    return put(PSI, value);
  }

  @Override
  protected void move(PointConversion conversion) {
    psi(conversion.heading(center(), psi()));
    super.move(conversion);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toBox(referenceFrame(), metres(from), psi(), Point.of(length(), width(), 0.0));
  }
}
