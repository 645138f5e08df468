package org.u2sa.messages;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** Motion of an object and its uncertainty: a view that reads and sets the object's own fields. */
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
   * in GLOBAL east, north, up. Empty if unknown; an absent z component counts as 0.
   */
  public Optional<Point> velocity() {
    return triple(fields.xDot(), fields.yDot(), fields.zDot());
  }

  public ObjectMotion velocity(Point value) {
    return set(fields.xDot(), fields.yDot(), fields.zDot(), value);
  }

  /**
   * Standard deviations of the position along the axes of the object's frame [m]; in GLOBAL east,
   * north, up. Empty if unknown.
   */
  public Optional<Point> sigma() {
    return triple(fields.xSigma(), fields.ySigma(), fields.zSigma());
  }

  /** Sets {@link #sigma()}; components must not be negative. */
  public ObjectMotion sigma(Point value) {
    return set(fields.xSigma(), fields.ySigma(), fields.zSigma(), value);
  }

  /** Standard deviation of the velocity along each axis [m/s]; empty if unknown. */
  public OptionalDouble velocitySigma() {
    return number(fields.velocitySigma());
  }

  public ObjectMotion velocitySigma(double value) {
    fields.velocitySigma().set(object, value);
    return this;
  }

  /** Validity period of the velocity [s]; empty if unknown. */
  public OptionalDouble horizon() {
    return number(fields.horizon());
  }

  public ObjectMotion horizon(double value) {
    fields.horizon().set(object, value);
    return this;
  }

  /** Converts to another frame's axes; called before centre and frame are changed. */
  void turn(PointConversion conversion, Point center) {
    velocity().ifPresent(velocity -> velocity(conversion.vector(center, velocity)));
    sigma().ifPresent(sigma -> sigma(conversion.positionSigma(center, sigma)));
  }

  /** Predicts the standard deviations of the position. */
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
