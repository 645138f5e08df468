package org.u2sa.messages.shape;

import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A solid sphere around the centre. */
public class Sphere extends ShapeSetters<Sphere> {
  private static final Schema<Sphere> SCHEMA =
      Schema.of(Sphere.class, Sphere::new, ShapeDescription.TYPE);
  private static final NumberField<Sphere> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);

  public static final MessageType<Sphere> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Sphere> type() {
    return TYPE;
  }

  /** Radius [m]; defaults to 0, a point. */
  public double radius() {
    return require(RADIUS);
  }

  public Sphere radius(double value) {
    return put(RADIUS, value);
  }

  @Override
  public double distanceTo(Point from) {
    return Math.max(0.0, metres(from).distance() - radius());
  }
}
