package org.u2sa.messages.goal;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A position to reach (thesis 3.2.3.4, figure 8): any of x, y, z, and optionally attitude, time and
 * speed on arrival.
 */
public class Waypoint extends GoalInformation {
  private static final Schema<Waypoint> SCHEMA =
      Schema.of(Waypoint.class, Waypoint::new, GoalInformation.TYPE);
  private static final ValueField<Waypoint, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final NumberField<Waypoint> X = SCHEMA.optionalCoordinate("x");
  private static final NumberField<Waypoint> Y = SCHEMA.optionalCoordinate("y");
  private static final NumberField<Waypoint> Z = SCHEMA.optionalNumber("z", "m");
  private static final NumberField<Waypoint> PHI = SCHEMA.optionalNumber("phi", "rad");
  private static final NumberField<Waypoint> THETA = SCHEMA.optionalNumber("theta", "rad");
  private static final NumberField<Waypoint> PSI = SCHEMA.optionalNumber("psi", "rad");
  private static final NumberField<Waypoint> TIME = SCHEMA.optionalNumber("time", "s");
  private static final NumberField<Waypoint> HORIZONTAL_THRESHOLD =
      SCHEMA.requiredNumber("horizontalThreshold", "m", 0.0, Double.POSITIVE_INFINITY);
  private static final NumberField<Waypoint> VERTICAL_THRESHOLD =
      SCHEMA.optionalNumber("verticalThreshold", "m", 0.0);
  private static final NumberField<Waypoint> SPEED = SCHEMA.optionalNumber("speed", "m/s", 0.0);
  private static final NumberField<Waypoint> PHOTO_DISTANCE =
      SCHEMA.since(3).optionalNumberWithoutBit("photoDistance", "m", 0.0);
  private static final ValueField<Waypoint, Point> LOOK_AT = SCHEMA.optionalPoint("lookAt", "m");
  private static final ValueField<Waypoint, Boolean> LANDING_START =
      SCHEMA.optionalFlagWithoutBit("landingStart");

  static {
    SCHEMA.alias("reference", REFERENCE_FRAME); // the thesis's mission example, 3.2.3.2
  }

  public static final MessageType<Waypoint> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Waypoint> type() {
    return TYPE;
  }

  /** Axes of position and attitude; defaults to GLOBAL. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  public Waypoint referenceFrame(ReferenceFrame frame) {
    return put(REFERENCE_FRAME, frame);
  }

  /** Position along x [m]; longitude [deg, east +] in GLOBAL; empty: any. */
  public OptionalDouble x() {
    return get(X);
  }

  public Waypoint x(double value) {
    return put(X, value);
  }

  /** Position along y [m]; latitude [deg, north +] in GLOBAL; empty: any. */
  public OptionalDouble y() {
    return get(Y);
  }

  public Waypoint y(double value) {
    return put(Y, value);
  }

  /** Position along z [m]; altitude above mean sea level in GLOBAL; empty: any. */
  public OptionalDouble z() {
    return get(Z);
  }

  public Waypoint z(double value) {
    return put(Z, value);
  }

  /** Roll on arrival [rad]; empty: any. */
  public OptionalDouble phi() {
    return get(PHI);
  }

  public Waypoint phi(double value) {
    return put(PHI, value);
  }

  /** Pitch on arrival [rad]; empty: any. */
  public OptionalDouble theta() {
    return get(THETA);
  }

  public Waypoint theta(double value) {
    return put(THETA, value);
  }

  /** Heading on arrival [rad]; empty: any. */
  public OptionalDouble psi() {
    return get(PSI);
  }

  public Waypoint psi(double value) {
    return put(PSI, value);
  }

  /** Time of arrival [s since the start of the mission]; empty: any. */
  public OptionalDouble time() {
    return get(TIME);
  }

  public Waypoint time(double value) {
    return put(TIME, value);
  }

  /** Horizontal distance within which the waypoint counts as reached [m]. */
  public double horizontalThreshold() {
    return require(HORIZONTAL_THRESHOLD);
  }

  public Waypoint horizontalThreshold(double metres) {
    return put(HORIZONTAL_THRESHOLD, metres);
  }

  /** Altitude difference within which the waypoint counts as reached [m]; empty: any. */
  public OptionalDouble verticalThreshold() {
    return get(VERTICAL_THRESHOLD);
  }

  public Waypoint verticalThreshold(double value) {
    return put(VERTICAL_THRESHOLD, value);
  }

  /** Speed on the way to the waypoint, relative to the fluid [m/s]; empty: any. */
  public OptionalDouble speed() {
    return get(SPEED);
  }

  public Waypoint speed(double value) {
    return put(SPEED, value);
  }

  /** Distance travelled between images on the way to the waypoint [m]; empty: no images. */
  public OptionalDouble photoDistance() {
    return get(PHOTO_DISTANCE);
  }

  public Waypoint photoDistance(double metres) {
    return put(PHOTO_DISTANCE, metres);
  }

  /**
   * Point that the camera looks at on the way to the waypoint, coordinates as x, y and z of {@link
   * #referenceFrame}; empty: none.
   */
  public Optional<Point> lookAt() {
    return Optional.ofNullable(get(LOOK_AT));
  }

  public Waypoint lookAt(Point point) {
    return put(LOOK_AT, point);
  }

  /** Whether returning and landing begin with this goal; defaults to false. */
  public boolean landingStart() {
    return Boolean.TRUE.equals(get(LANDING_START));
  }

  public Waypoint landingStart(boolean value) {
    return put(LANDING_START, value);
  }

  @Override
  public Waypoint uid(String uid) {
    return (Waypoint) super.uid(uid);
  }

  @Override
  public Waypoint completed(boolean completed) {
    return (Waypoint) super.completed(completed);
  }

  @Override
  public Waypoint next(List<String> uids) {
    return (Waypoint) super.next(uids);
  }

  @Override
  public Waypoint description(String text) {
    return (Waypoint) super.description(text);
  }

  @Override
  public Waypoint copy() {
    return (Waypoint) super.copy();
  }
}
