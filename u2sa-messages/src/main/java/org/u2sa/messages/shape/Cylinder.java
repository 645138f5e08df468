package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A solid cylinder around the centre, its axis along z. */
public class Cylinder extends ShapeDescription {
  private static final Schema<Cylinder> SCHEMA =
      Schema.of("Cylinder", Cylinder.class, Cylinder::new, ShapeDescription.TYPE);
  private static final NumberField<Cylinder> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);
  private static final NumberField<Cylinder> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);

  /** The schema. */
  public static final MessageType<Cylinder> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Cylinder> type() {
    return TYPE;
  }

  /** Radius [m], 0 until set: a point. */
  public double radius() {
    return require(RADIUS);
  }

  /** Sets {@link #radius()}. */
  public Cylinder radius(double value) {
    put(RADIUS, value);
    return this;
  }

  /** Height [m], half of it to each side of the centre. */
  public double height() {
    return require(HEIGHT);
  }

  /** Sets {@link #height()}. */
  public Cylinder height(double value) {
    put(HEIGHT, value);
    return this;
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toDisc(metres(from), radius(), height());
  }

  @Override
  public Cylinder uid(String uid) {
    super.uid(uid);
    return this;
  }

  @Override
  public Cylinder objectType(String type) {
    super.objectType(type);
    return this;
  }

  @Override
  public Cylinder referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return this;
  }

  @Override
  public Cylinder x(double x) {
    super.x(x);
    return this;
  }

  @Override
  public Cylinder y(double y) {
    super.y(y);
    return this;
  }

  @Override
  public Cylinder z(double z) {
    super.z(z);
    return this;
  }

  @Override
  public Cylinder level(ObjectLevel level) {
    super.level(level);
    return this;
  }
}
