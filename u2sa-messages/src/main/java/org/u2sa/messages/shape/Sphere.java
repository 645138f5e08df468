package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A ball around the centre. */
public class Sphere extends ShapeDescription {
  private static final Schema<Sphere> SCHEMA =
      Schema.of("Sphere", Sphere.class, Sphere::new, ShapeDescription.TYPE);
  private static final NumberField<Sphere> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);

  /** The schema. */
  public static final MessageType<Sphere> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Sphere> type() {
    return TYPE;
  }

  /** Radius [m], 0 until set: a point. */
  public double radius() {
    return require(RADIUS);
  }

  /** Sets {@link #radius()}. */
  public Sphere radius(double value) {
    put(RADIUS, value);
    return this;
  }

  @Override
  public double distanceTo(Point from) {
    return Math.max(0.0, metres(from).distance() - radius());
  }

  @Override
  public Sphere uid(String uid) {
    super.uid(uid);
    return this;
  }

  @Override
  public Sphere objectType(String type) {
    super.objectType(type);
    return this;
  }

  @Override
  public Sphere referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return this;
  }

  @Override
  public Sphere x(double x) {
    super.x(x);
    return this;
  }

  @Override
  public Sphere y(double y) {
    super.y(y);
    return this;
  }

  @Override
  public Sphere z(double z) {
    super.z(z);
    return this;
  }

  @Override
  public Sphere level(ObjectLevel level) {
    super.level(level);
    return this;
  }
}
