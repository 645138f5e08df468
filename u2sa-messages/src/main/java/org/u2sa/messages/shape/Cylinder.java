package org.u2sa.messages.shape;

import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A solid cylinder around the centre, its axis along z. */
public class Cylinder extends ShapeSetters<Cylinder> {
  private static final Schema<Cylinder> SCHEMA =
      Schema.of(Cylinder.class, Cylinder::new, ShapeDescription.TYPE);
  private static final NumberField<Cylinder> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);
  private static final NumberField<Cylinder> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);

  public static final MessageType<Cylinder> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Cylinder> type() {
    return TYPE;
  }

  /** Radius [m]; defaults to 0, a point. */
  public double radius() {
    return require(RADIUS);
  }

  public Cylinder radius(double value) {
    return put(RADIUS, value);
  }

  /** Height [m], centred on z. */
  public double height() {
    return require(HEIGHT);
  }

  public Cylinder height(double value) {
    return put(HEIGHT, value);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toDisc(metres(from), radius(), height());
  }
}
