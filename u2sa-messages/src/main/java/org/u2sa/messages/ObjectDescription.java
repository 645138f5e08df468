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
 * Something in the environment (thesis 3.2.3.5, figure 9). This class itself is a single point, as
 * an ultrasonic or infrared range finder sees it.
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

  /** The schema. */
  public static final MessageType<ObjectDescription> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ObjectDescription> type() {
    return TYPE;
  }

  /** Unique among the objects of a system. */
  public String uid() {
    return require(UID);
  }

  /** Sets {@link #uid()}. */
  public ObjectDescription uid(String uid) {
    return put(UID, uid);
  }

  /** What it is to the mission, "barrel", "gate"; empty if unknown. */
  public String objectType() {
    return get(OBJECT_TYPE);
  }

  /** Sets {@link #objectType()}. */
  public ObjectDescription objectType(String type) {
    return put(OBJECT_TYPE, type);
  }

  /** The axes of the centre and of all points; GLOBAL until set. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  /** Sets {@link #referenceFrame()}. */
  public ObjectDescription referenceFrame(ReferenceFrame frame) {
    return put(REFERENCE_FRAME, frame);
  }

  /** The centre along x [m]; longitude [deg] in GLOBAL. */
  public double x() {
    return require(X);
  }

  /** Sets {@link #x()}. */
  public ObjectDescription x(double value) {
    return put(X, value);
  }

  /** The centre along y [m]; latitude [deg] in GLOBAL. */
  public double y() {
    return require(Y);
  }

  /** Sets {@link #y()}. */
  public ObjectDescription y(double value) {
    return put(Y, value);
  }

  /**
   * The centre along z [m]; altitude in GLOBAL. 0 until set: a plane world, as in the thesis's
   * circle (3.2.3.3).
   */
  public double z() {
    return require(Z);
  }

  /** Sets {@link #z()}. */
  public ObjectDescription z(double value) {
    return put(Z, value);
  }

  /** How much to avoid it; empty if nobody said. */
  public Optional<ObjectLevel> level() {
    return Optional.ofNullable(get(LEVEL));
  }

  /** Sets {@link #level()}. */
  public ObjectDescription level(ObjectLevel level) {
    return put(LEVEL, level);
  }

  /** How certain it is that the object is there [0…1]; empty if nobody said. */
  public OptionalDouble confidence() {
    return get(CONFIDENCE);
  }

  /** Sets {@link #confidence()}. */
  public ObjectDescription confidence(double value) {
    return put(CONFIDENCE, value);
  }

  /** What saw it; empty if nobody said, as of what a file describes. */
  public String sensorName() {
    String name = get(SENSOR_NAME);
    return name == null ? "" : name;
  }

  /** Sets {@link #sensorName()}. */
  public ObjectDescription sensorName(String name) {
    return put(SENSOR_NAME, name);
  }

  /**
   * How it moves and how well that is known: velocity, standard deviations, for how long the
   * velocity holds.
   */
  public final ObjectMotion motion() {
    return new ObjectMotion(MOTION, this);
  }

  /** The centre. */
  public final Point center() {
    return Point.of(x(), y(), z());
  }

  /**
   * Distance from a point to the closest point of the object [m]; 0 inside. Every shape implements
   * its own.
   *
   * @param from in the object's own frame; in GLOBAL longitude, latitude [deg] and altitude [m]
   */
  public double distanceTo(Point from) {
    return metres(from).distance();
  }

  /** A point of the object's frame as metres from the centre, in GLOBAL east, north and up. */
  protected final Point metres(Point point) {
    return metric().metres(point);
  }

  /** The same for many points. */
  protected final Metric metric() {
    return Metric.around(referenceFrame(), center());
  }

  /**
   * The same object in another frame, as a new message. Its velocity is turned; its standard
   * deviations are too, and on a way from or to BODY the vehicle's are added. What is absent stays
   * absent.
   *
   * @param vehicle where the vehicle is and how it stands, in GLOBAL or UTM for a way between BODY
   *     and the earth, in LOCAL_ENU or LOCAL_NED for one between BODY and local frames; absent roll
   *     and pitch count as level, an absent altitude as 0
   * @throws IllegalArgumentException naming both frames, if this cannot be done
   */
  public ObjectDescription in(ReferenceFrame frame, StateInformation vehicle) {
    ObjectDescription moved = copy();
    moved.move(PointConversion.of(type(), referenceFrame(), frame, vehicle));
    return moved.referenceFrame(frame);
  }

  /**
   * Where the object will be if it goes on as it moves, as a new message; the same place if no
   * velocity is known. Standard deviations grow as the velocity's does.
   *
   * @param seconds from the time that the message is of; negative: where it was
   */
  public ObjectDescription after(double seconds) {
    ObjectDescription moved = copy();
    Optional<Point> velocity = motion().velocity();
    if (velocity.isPresent()) {
      moved.shift(scaled(velocity.get(), seconds));
      moved.motion().grow(seconds);
    }
    timestamp()
        .ifPresent(micros -> moved.timestamp(micros + Math.round(seconds * MICROS_PER_SECOND)));
    return moved;
  }

  /** The same object around another centre, as a new message: its points move along. */
  public ObjectDescription movedTo(Point newCenter) {
    ObjectDescription moved = copy();
    moved.shift(metres(newCenter));
    moved.x(newCenter.x()).y(newCenter.y()).z(newCenter.z()); // to the last digit
    return moved;
  }

  /** Moves the centre and all points by metres along the frame's axes. */
  private void shift(Point way) {
    Metric around = metric();
    eachPoint(point -> around.point(around.metres(point).plus(way)));
    Point center = around.point(way);
    x(center.x()).y(center.y()).z(center.z());
  }

  private static Point scaled(Point v, double factor) {
    return Point.of(factor * v.x(), factor * v.y(), factor * v.z());
  }

  /**
   * Moves the centre, and the points of every list of points; called while the frame is still the
   * old one.
   */
  protected void move(PointConversion conversion) {
    eachPoint(conversion::convert);
    Point center = conversion.convert(center());
    motion().turn(conversion, center());
    x(center.x()).y(center.y()).z(center.z());
  }

  /** Replaces every point of every list of points. */
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
