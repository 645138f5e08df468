package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.PointConversion;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A solid box around the centre, upright: its height is along z. */
public class Box extends ShapeDescription {
  private static final Schema<Box> SCHEMA =
      Schema.of("Box", Box.class, Box::new, ShapeDescription.TYPE);
  private static final NumberField<Box> LENGTH = SCHEMA.number("length", "m", 0.0, 0.0);
  private static final NumberField<Box> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);
  private static final NumberField<Box> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);
  private static final NumberField<Box> PSI = SCHEMA.number("psi", "rad", 0.0);

  /** The schema. */
  public static final MessageType<Box> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Box> type() {
    return TYPE;
  }

  /** Length, along the direction of psi [m]. */
  public double length() {
    return require(LENGTH);
  }

  /** Sets {@link #length()}. */
  public Box length(double value) {
    put(LENGTH, value);
    return this;
  }

  /** Width, across the direction of psi [m]. */
  public double width() {
    return require(WIDTH);
  }

  /** Sets {@link #width()}. */
  public Box width(double value) {
    put(WIDTH, value);
    return this;
  }

  /** Height [m], half of it to each side of the centre. */
  public double height() {
    return require(HEIGHT);
  }

  /** Sets {@link #height()}. */
  public Box height(double value) {
    put(HEIGHT, value);
    return this;
  }

  /** Turn of the length axis from the frame's own zero [rad]: in the frame's sense of psi. */
  public double psi() {
    return require(PSI);
  }

  /** Sets {@link #psi()}. */
  public Box psi(double value) {
    put(PSI, value);
    return this;
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

  @Override
  public Box uid(String uid) {
    super.uid(uid);
    return this;
  }

  @Override
  public Box objectType(String type) {
    super.objectType(type);
    return this;
  }

  @Override
  public Box referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return this;
  }

  @Override
  public Box x(double x) {
    super.x(x);
    return this;
  }

  @Override
  public Box y(double y) {
    super.y(y);
    return this;
  }

  @Override
  public Box z(double z) {
    super.z(z);
    return this;
  }

  @Override
  public Box level(ObjectLevel level) {
    super.level(level);
    return this;
  }
}
