package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A disc in the x-y plane around the centre. */
public class Circle extends ShapeDescription {
  private static final Schema<Circle> SCHEMA =
      Schema.of("Circle", Circle.class, Circle::new, ShapeDescription.TYPE);
  private static final NumberField<Circle> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);

  /** The schema. */
  public static final MessageType<Circle> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Circle> type() {
    return TYPE;
  }

  /** Radius [m], 0 until set: a point. */
  public double radius() {
    return require(RADIUS);
  }

  /** Sets {@link #radius()}. */
  public Circle radius(double value) {
    put(RADIUS, value);
    return this;
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toDisc(metres(from), radius(), 0.0);
  }

  @Override
  public Circle uid(String uid) {
    super.uid(uid);
    return this;
  }

  @Override
  public Circle objectType(String type) {
    super.objectType(type);
    return this;
  }

  @Override
  public Circle referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return this;
  }

  @Override
  public Circle x(double x) {
    super.x(x);
    return this;
  }

  @Override
  public Circle y(double y) {
    super.y(y);
    return this;
  }

  @Override
  public Circle z(double z) {
    super.z(z);
    return this;
  }

  @Override
  public Circle level(ObjectLevel level) {
    super.level(level);
    return this;
  }
}
