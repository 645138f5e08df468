package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Target of a vehicle or a subsystem for the next time step: the error vector of the control system
 * (thesis 3.2.3.8, figure 12).
 */
public class NavigationPoint extends U2SAData {
  private static final Schema<NavigationPoint> SCHEMA =
      Schema.of(NavigationPoint.class, NavigationPoint::new, U2SAData.TYPE);
  private static final ValueField<NavigationPoint, String> SUBSYSTEM =
      SCHEMA.name("subsystem", "VEHICLE");
  private static final ValueField<NavigationPoint, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.BODY);
  private static final ValueField<NavigationPoint, Point> POINT =
      SCHEMA.requiredPoint("point", "m");
  private static final NumberField<NavigationPoint> SPEED =
      SCHEMA.optionalNumber("speed", "m/s", 0.0);
  private static final ValueField<NavigationPoint, Boolean> BACKWARDS =
      SCHEMA.since(3).optionalFlag("backwards");
  private static final NumberField<NavigationPoint> TURN = SCHEMA.optionalNumber("turn", "rad");

  public static final MessageType<NavigationPoint> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends NavigationPoint> type() {
    return TYPE;
  }

  /** Subsystem to move; defaults to "VEHICLE". */
  public String subsystem() {
    return require(SUBSYSTEM);
  }

  public NavigationPoint subsystem(String value) {
    return put(SUBSYSTEM, value);
  }

  /** Axes of the point; defaults to BODY. */
  public ReferenceFrame referenceFrame() {
    return require(REFERENCE_FRAME);
  }

  public NavigationPoint referenceFrame(ReferenceFrame value) {
    return put(REFERENCE_FRAME, value);
  }

  /** The point to reach, in the message's frame. */
  public Point point() {
    return require(POINT);
  }

  public NavigationPoint point(Point value) {
    return put(POINT, value);
  }

  /** Speed, relative to the fluid [m/s]; empty: chosen by control. */
  public OptionalDouble speed() {
    return get(SPEED);
  }

  public NavigationPoint speed(double value) {
    return put(SPEED, value);
  }

  /** Whether to drive there in reverse; defaults to false. */
  public boolean backwards() {
    return Boolean.TRUE.equals(get(BACKWARDS));
  }

  public NavigationPoint backwards(boolean value) {
    return put(BACKWARDS, value);
  }

  /**
   * Turn that leads to the desired heading, relative to the vehicle's heading at the timestamp,
   * positive to the right [rad]; empty: control chooses the heading.
   */
  public OptionalDouble turn() {
    return get(TURN);
  }

  public NavigationPoint turn(double value) {
    return put(TURN, value);
  }

  /** Creates a target for the vehicle itself, in BODY. */
  public static NavigationPoint at(Point point) {
    return new NavigationPoint().point(point);
  }

  /**
   * Copy in another frame.
   *
   * @param vehicle the vehicle's pose, in GLOBAL or UTM to convert between BODY and those frames,
   *     in LOCAL_ENU or LOCAL_NED to convert between BODY and local frames; absent roll, pitch and
   *     altitude count as 0
   * @throws IllegalArgumentException naming both frames, if no conversion exists
   */
  public NavigationPoint in(ReferenceFrame frame, StateInformation vehicle) {
    PointConversion conversion = PointConversion.of(type(), referenceFrame(), frame, vehicle);
    return copy().referenceFrame(frame).point(conversion.convert(point()));
  }

  @Override
  public NavigationPoint copy() {
    return (NavigationPoint) super.copy();
  }
}
