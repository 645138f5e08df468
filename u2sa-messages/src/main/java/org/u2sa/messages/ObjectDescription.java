package org.u2sa.messages;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * An object in the environment (thesis 3.2.3.5, figure 9). This class itself describes a single
 * point, as detected by an ultrasonic or infrared range finder.
 */
public class ObjectDescription extends U2SAData {
  private static final double MICROS_PER_SECOND = 1e6;
  private static final Schema<ObjectDescription> SCHEMA =
      Schema.of(ObjectDescription.class, ObjectDescription::new, U2SAData.TYPE);
  private static final ValueField<ObjectDescription, String> UID = SCHEMA.requiredId("uid");
  private static final ValueField<ObjectDescription, String> OBJECT_TYPE =
      SCHEMA.name("objectType", "");
  private static final ValueField<ObjectDescription, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final NumberField<ObjectDescription> X = SCHEMA.requiredCoordinate("x");
  private static final NumberField<ObjectDescription> Y = SCHEMA.requiredCoordinate("y");
  private static final NumberField<ObjectDescription> Z = SCHEMA.number("z", "m", 0.0);
  private static final ValueField<ObjectDescription, ObjectLevel> LEVEL =
      SCHEMA.optionalChoice("level", ObjectLevel.class);
  private static final ObjectMotion.Fields MOTION = ObjectMotion.declare(SCHEMA.since(3));
  private static final NumberField<ObjectDescription> CONFIDENCE =
      SCHEMA.optionalNumber("confidence", "", 0.0, 1.0);
  private static final ValueField<ObjectDescription, String> SENSOR_NAME =
      SCHEMA.optionalName("sensorName");

  static {
    SCHEMA.alias("type", OBJECT_TYPE); // figure 9's name; on the wire "type" is the message's own
    SCHEMA.alias("reference", REFERENCE_FRAME);
  }

  public static final MessageType<ObjectDescription> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ObjectDescription> type() {
    return TYPE;
  }

  /** Identifier, unique within the system. */
  public String uid() {
    return require(UID);
  }

  public ObjectDescription uid(String uid) {
    return put(UID, uid);
  }

  /** Object type as named in the mission, such as "barrel" or "gate"; empty if unknown. */
  public String objectType() {
    return get(OBJECT_TYPE);
  }

  public ObjectDescription objectType(String type) {
    return put(OBJECT_TYPE, type);
  }

  /** Axes of the centre and of all points; defaults to GLOBAL. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  public ObjectDescription referenceFrame(ReferenceFrame frame) {
    return put(REFERENCE_FRAME, frame);
  }

  /** Centre along x [m]; longitude [deg] in GLOBAL. */
  public double x() {
    return require(X);
  }

  public ObjectDescription x(double value) {
    return put(X, value);
  }

  /** Centre along y [m]; latitude [deg] in GLOBAL. */
  public double y() {
    return require(Y);
  }

  public ObjectDescription y(double value) {
    return put(Y, value);
  }

  /**
   * Centre along z [m]; altitude in GLOBAL. Defaults to 0: a flat world, as in the thesis's circle
   * (3.2.3.3).
   */
  public double z() {
    return require(Z);
  }

  public ObjectDescription z(double value) {
    return put(Z, value);
  }

  /** Strictness of avoidance; empty if unknown. */
  public Optional<ObjectLevel> level() {
    return Optional.ofNullable(get(LEVEL));
  }

  public ObjectDescription level(ObjectLevel level) {
    return put(LEVEL, level);
  }

  /**
   * Confidence that the object exists [0…1]; empty if unknown. A sensor that has looked and seen
   * nothing may report this as an object of confidence 0, which no map includes.
   */
  public OptionalDouble confidence() {
    return get(CONFIDENCE);
  }

  public ObjectDescription confidence(double value) {
    return put(CONFIDENCE, value);
  }

  /** Name of the detecting sensor; empty if unknown, for example for objects from a file. */
  public String sensorName() {
    String name = get(SENSOR_NAME);
    return name == null ? "" : name;
  }

  public ObjectDescription sensorName(String name) {
    return put(SENSOR_NAME, name);
  }

  /**
   * Motion and its uncertainty: velocity, standard deviations, and validity period of the velocity.
   */
  public final ObjectMotion motion() {
    return new ObjectMotion(MOTION, this);
  }

  /** The centre. */
  public final Point center() {
    return Point.of(x(), y(), z());
  }

  /**
   * Distance from a point to the closest point of the object [m]; 0 inside. Each shape has its own
   * implementation.
   *
   * @param from point in the object's own frame; in GLOBAL longitude, latitude [deg] and altitude
   *     [m]
   */
  public double distanceTo(Point from) {
    return metres(from).distance();
  }

  /**
   * Converts a point of the object's frame to metres from the centre; east, north and up in GLOBAL.
   */
  protected final Point metres(Point point) {
    return metric().metres(point);
  }

  /** Converts several points to metres from the centre. */
  protected final Metric metric() {
    return Metric.around(referenceFrame(), center());
  }

  /**
   * Copy in another frame. Velocity and standard deviations are rotated; conversions from or to
   * BODY add the vehicle's standard deviations. Absent fields stay absent.
   *
   * @param vehicle the vehicle's pose, in GLOBAL or UTM to convert between BODY and those frames,
   *     in LOCAL_ENU or LOCAL_NED to convert between BODY and local frames; absent roll, pitch and
   *     altitude count as 0
   * @throws IllegalArgumentException naming both frames, if no conversion exists
   */
  public ObjectDescription in(ReferenceFrame frame, StateInformation vehicle) {
    ObjectDescription moved = copy();
    moved.move(PointConversion.of(type(), referenceFrame(), frame, vehicle));
    return moved.referenceFrame(frame);
  }

  /**
   * Copy predicted at constant velocity; unmoved if the velocity is unknown. Standard deviations
   * grow with the velocity's.
   *
   * @param seconds since the message's timestamp; negative for the past
   */
  public ObjectDescription after(double seconds) {
    ObjectDescription moved = copy();
    Optional<Point> velocity = motion().velocity();
    if (velocity.isPresent()) {
      moved.shift(velocity.get().times(seconds));
      moved.motion().grow(seconds);
    }
    timestamp()
        .ifPresent(micros -> moved.timestamp(micros + Math.round(seconds * MICROS_PER_SECOND)));
    return moved;
  }

  /** Copy around another centre; its points move along. */
  public ObjectDescription movedTo(Point newCenter) {
    ObjectDescription moved = copy();
    moved.shift(metres(newCenter));
    moved.x(newCenter.x()).y(newCenter.y()).z(newCenter.z()); // exact to the last digit
    return moved;
  }

  /** Translates the centre and all points along the frame's axes [m]. */
  private void shift(Point way) {
    Metric around = metric();
    eachPoint(point -> around.point(around.metres(point).plus(way)));
    Point center = around.point(way);
    x(center.x()).y(center.y()).z(center.z());
  }

  /** Maps the centre and all lists of points; called before the frame is changed. */
  protected void move(PointConversion conversion) {
    eachPoint(conversion::convert);
    Point center = conversion.convert(center());
    motion().turn(conversion, center());
    x(center.x()).y(center.y()).z(center.z());
  }

  /** Maps every point of all lists of points. */
  private void eachPoint(UnaryOperator<Point> change) {
    for (MessageField<U2SAData> field : ownType().fields()) {
      if (field.kind() == Kind.POINT_LIST) {
        List<Point> points = new ArrayList<>();
        for (Object point : (List<?>) field.get(this).get()) {
          points.add(change.apply((Point) point));
        }
        field.set(this, points);
      }
    }
  }

  @Override
  public ObjectDescription copy() {
    return (ObjectDescription) super.copy();
  }
}
