package org.u2sa.messages.shape;

import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Setters common to all shapes, which return the shape itself.
 *
 * @param <S> the shape
 */
abstract class ShapeSetters<S extends ShapeDescription> extends ShapeDescription {
  @Override
  public S uid(String uid) {
    super.uid(uid);
    return self();
  }

  @Override
  public S objectType(String type) {
    super.objectType(type);
    return self();
  }

  @Override
  public S referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return self();
  }

  @Override
  public S x(double x) {
    super.x(x);
    return self();
  }

  @Override
  public S y(double y) {
    super.y(y);
    return self();
  }

  @Override
  public S z(double z) {
    super.z(z);
    return self();
  }

  @Override
  public S level(ObjectLevel level) {
    super.level(level);
    return self();
  }

  @SuppressWarnings("unchecked") // a shape extends the setters of its own class
  private S self() {
    return (S) this;
  }
}
