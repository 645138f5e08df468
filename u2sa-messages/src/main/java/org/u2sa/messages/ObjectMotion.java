package org.u2sa.messages;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * How an object moves and how well that is known: a view of the object's own fields, read and set
 * through it.
 */
public final class ObjectMotion {
  /** The fields, in wire order. */
  record Fields(
      NumberField<ObjectDescription> xDot,
      NumberField<ObjectDescription> yDot,
      NumberField<ObjectDescription> zDot,
      NumberField<ObjectDescription> xSigma,
      NumberField<ObjectDescription> ySigma,
      NumberField<ObjectDescription> zSigma,
      NumberField<ObjectDescription> velocitySigma,
      NumberField<ObjectDescription> horizon) {}

  private final Fields fields;
  private final ObjectDescription object;

  ObjectMotion(Fields fields, ObjectDescription object) {
    this.fields = fields;
    this.object = object;
  }

  static Fields declare(Schema<ObjectDescription> schema) {
    return new Fields(
        schema.optionalNumber("xDot", "m/s"),
        schema.optionalNumber("yDot", "m/s"),
        schema.optionalNumber("zDot", "m/s"),
        schema.optionalNumber("xSigma", "m", 0.0),
        schema.optionalNumber("ySigma", "m", 0.0),
        schema.optionalNumber("zSigma", "m", 0.0),
        schema.optionalNumber("velocitySigma", "m/s", 0.0),
        schema.optionalNumber("horizon", "s", 0.0));
  }

  /**
   * Velocity over ground, not relative to the vehicle, along the axes of the object's frame [m/s];
   * in GLOBAL east, north, up. Empty if not known; without one along z it counts as level.
   */
  public Optional<Point> velocity() {
    return triple(fields.xDot(), fields.yDot(), fields.zDot());
  }

  /** Sets {@link #velocity()}. */
  public ObjectMotion velocity(Point value) {
    return set(fields.xDot(), fields.yDot(), fields.zDot(), value);
  }

  /**
   * Standard deviations of the place along the axes of the object's frame [m]; in GLOBAL east,
   * north, up. Empty if not known.
   */
  public Optional<Point> sigma() {
    return triple(fields.xSigma(), fields.ySigma(), fields.zSigma());
  }

  /** Sets {@link #sigma()}; none is negative. */
  public ObjectMotion sigma(Point value) {
    return set(fields.xSigma(), fields.ySigma(), fields.zSigma(), value);
  }

  /** Standard deviation of the velocity along each axis [m/s]; empty if not known. */
  public OptionalDouble velocitySigma() {
    return number(fields.velocitySigma());
  }

  /** Sets {@link #velocitySigma()}. */
  public ObjectMotion velocitySigma(double value) {
    fields.velocitySigma().set(object, value);
    return this;
  }

  /** For how long the velocity may be relied on [s]; empty if nobody said. */
  public OptionalDouble horizon() {
    return number(fields.horizon());
  }

  /** Sets {@link #horizon()}. */
  public ObjectMotion horizon(double value) {
    fields.horizon().set(object, value);
    return this;
  }

  /** Into the axes of another frame; called while centre and frame are still the old ones. */
  void turn(PointConversion conversion, Point center) {
    velocity().ifPresent(velocity -> velocity(conversion.vector(center, velocity)));
    sigma().ifPresent(sigma -> sigma(conversion.positionSigma(center, sigma)));
  }

  /** The place's standard deviations after some time. */
  void grow(double seconds) {
    sigma()
        .ifPresent(
            sigma -> {
              double more = seconds * velocitySigma().orElse(0.0);
              sigma(
                  Point.of(
                      Math.hypot(sigma.x(), more),
                      Math.hypot(sigma.y(), more),
                      Math.hypot(sigma.z(), more)));
            });
  }

  private Optional<Point> triple(
      NumberField<ObjectDescription> x,
      NumberField<ObjectDescription> y,
      NumberField<ObjectDescription> z) {
    OptionalDouble along = number(x);
    OptionalDouble across = number(y);
    return along.isPresent() && across.isPresent()
        ? Optional.of(Point.of(along.getAsDouble(), across.getAsDouble(), number(z).orElse(0.0)))
        : Optional.empty();
  }

  private ObjectMotion set(
      NumberField<ObjectDescription> x,
      NumberField<ObjectDescription> y,
      NumberField<ObjectDescription> z,
      Point value) {
    x.set(object, value.x());
    y.set(object, value.y());
    z.set(object, value.z());
    return this;
  }

  private OptionalDouble number(NumberField<ObjectDescription> field) {
    Optional<Object> value = field.get(object);
    return value.isPresent() ? OptionalDouble.of((Double) value.get()) : OptionalDouble.empty();
  }
}
