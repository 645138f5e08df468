package org.u2sa.messages;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
  private static final Schema<ObjectDescription> SCHEMA =
      Schema.of(ObjectDescription.class, ObjectDescription::new, U2SAData.TYPE);
  private static final ValueField<ObjectDescription, String> UID = SCHEMA.requiredText("uid");
  private static final ValueField<ObjectDescription, String> OBJECT_TYPE =
      SCHEMA.text("objectType", "");
  private static final ValueField<ObjectDescription, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final NumberField<ObjectDescription> X = SCHEMA.requiredCoordinate("x");
  private static final NumberField<ObjectDescription> Y = SCHEMA.requiredCoordinate("y");
  private static final NumberField<ObjectDescription> Z = SCHEMA.number("z", "m", 0.0);
  private static final ValueField<ObjectDescription, ObjectLevel> LEVEL =
      SCHEMA.optionalChoice("level", ObjectLevel.class);

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
   * The same object in another frame, as a new message.
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
   * Moves the centre, and the points of every list of points; called while the frame is still the
   * old one.
   */
  protected void move(PointConversion conversion) {
    for (MessageField<U2SAData> field : ownType().fields()) {
      if (field.kind() == Kind.POINT_LIST) {
        List<Point> points = new ArrayList<>();
        for (Object point : (List<?>) field.get(this).get()) {
          points.add(conversion.convert((Point) point));
        }
        field.set(this, points);
      }
    }
    Point center = conversion.convert(center());
    x(center.x()).y(center.y()).z(center.z());
  }

  @Override
  public ObjectDescription copy() {
    return (ObjectDescription) super.copy();
  }
}
