package org.u2sa.messages.shape;

import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A disc in the x-y plane around the centre. */
public class Circle extends ShapeSetters<Circle> {
  private static final Schema<Circle> SCHEMA =
      Schema.of(Circle.class, Circle::new, ShapeDescription.TYPE);
  private static final NumberField<Circle> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);

  public static final MessageType<Circle> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Circle> type() {
    return TYPE;
  }

  /** Radius [m]; defaults to 0, a point. */
  public double radius() {
    return require(RADIUS);
  }

  public Circle radius(double value) {
    return put(RADIUS, value);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toDisc(metres(from), radius(), 0.0);
  }
}
