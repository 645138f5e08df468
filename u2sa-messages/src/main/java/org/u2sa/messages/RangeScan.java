package org.u2sa.messages;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * One revolution or sweep of a scanning range finder, beam by beam, including beams without an
 * echo: these are the evidence for free space.
 *
 * <p>The timestamp is that of the first beam. Beams lie in the plane of the sensor's x (ahead) and
 * y (left) axes.
 */
public final class RangeScan extends U2SAData {
  private static final Schema<RangeScan> SCHEMA =
      Schema.of(RangeScan.class, RangeScan::new, U2SAData.TYPE).since(3);
  private static final ValueField<RangeScan, String> SENSOR_NAME =
      SCHEMA.requiredName("sensorName");
  private static final ValueField<RangeScan, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.BODY);
  private static final NumberField<RangeScan> X = SCHEMA.number("x", "m", 0.0);
  private static final NumberField<RangeScan> Y = SCHEMA.number("y", "m", 0.0);
  private static final NumberField<RangeScan> Z = SCHEMA.number("z", "m", 0.0);
  private static final NumberField<RangeScan> PHI = SCHEMA.number("phi", "rad", 0.0);
  private static final NumberField<RangeScan> THETA = SCHEMA.number("theta", "rad", 0.0);
  private static final NumberField<RangeScan> PSI = SCHEMA.number("psi", "rad", 0.0);
  private static final NumberField<RangeScan> MIN_RANGE = SCHEMA.number("minRange", "m", 0.0, 0.0);
  private static final NumberField<RangeScan> MAX_RANGE =
      SCHEMA.requiredNumber("maxRange", "m", 0.0, Double.POSITIVE_INFINITY);
  private static final NumberField<RangeScan> TIME_INCREMENT =
      SCHEMA.number("timeIncrement", "s", 0.0, 0.0);
  private static final NumberField<RangeScan> START_ANGLE = SCHEMA.number("startAngle", "rad", 0.0);
  private static final NumberField<RangeScan> ANGLE_INCREMENT =
      SCHEMA.number("angleIncrement", "rad", 0.0);
  private static final ValueField<RangeScan, List<Double>> ANGLES = SCHEMA.numbers("angles", "rad");
  private static final ValueField<RangeScan, List<Double>> RANGES = SCHEMA.numbers("ranges", "m");
  private static final ValueField<RangeScan, List<Boolean>> RETURNS = SCHEMA.flags("returns");

  public static final MessageType<RangeScan> TYPE = SCHEMA.build();

  /**
   * One measurement.
   *
   * @param angle from the sensor's forward axis, positive to the left [rad]
   * @param range distance of the echo [m]; empty without an echo
   */
  public record Beam(double angle, OptionalDouble range) {}

  @Override
  public MessageType<RangeScan> type() {
    return TYPE;
  }

  /** Name of the scanner; distinguishes several scanners. */
  public String sensorName() {
    return require(SENSOR_NAME);
  }

  public RangeScan sensorName(String value) {
    return put(SENSOR_NAME, value);
  }

  /** Axes of the sensor's position and attitude; defaults to BODY. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  public RangeScan referenceFrame(ReferenceFrame value) {
    return put(REFERENCE_FRAME, value);
  }

  /** Sensor position along x [m]; forward in BODY. */
  public double x() {
    return get(X).orElseThrow();
  }

  public RangeScan x(double value) {
    return put(X, value);
  }

  /** Sensor position along y [m]; left in BODY. */
  public double y() {
    return get(Y).orElseThrow();
  }

  public RangeScan y(double value) {
    return put(Y, value);
  }

  /** Sensor position along z [m]; down in BODY. */
  public double z() {
    return get(Z).orElseThrow();
  }

  public RangeScan z(double value) {
    return put(Z, value);
  }

  /** Sensor roll [rad]; left side down positive in BODY. */
  public double phi() {
    return get(PHI).orElseThrow();
  }

  public RangeScan phi(double value) {
    return put(PHI, value);
  }

  /** Sensor pitch [rad]; front up positive in BODY. */
  public double theta() {
    return get(THETA).orElseThrow();
  }

  public RangeScan theta(double value) {
    return put(THETA, value);
  }

  /** Sensor yaw [rad]; to the left positive in BODY. */
  public double psi() {
    return get(PSI).orElseThrow();
  }

  public RangeScan psi(double value) {
    return put(PSI, value);
  }

  /** Minimum range [m]: closer returns come from the vehicle itself and are ignored. */
  public double minRange() {
    return get(MIN_RANGE).orElseThrow();
  }

  public RangeScan minRange(double value) {
    return put(MIN_RANGE, value);
  }

  /** Maximum range [m]: a beam without a return means that nothing detectable is closer. */
  public double maxRange() {
    return get(MAX_RANGE).orElseThrow();
  }

  public RangeScan maxRange(double value) {
    return put(MAX_RANGE, value);
  }

  /** Time between consecutive beams [s]; 0 if unknown. */
  public double timeIncrement() {
    return get(TIME_INCREMENT).orElseThrow();
  }

  public RangeScan timeIncrement(double value) {
    return put(TIME_INCREMENT, value);
  }

  /** Direction of the first beam [rad] from straight ahead; positive to the left in BODY. */
  public double startAngle() {
    return get(START_ANGLE).orElseThrow();
  }

  /** Angle between consecutive beams [rad]; negative if the scan turns to the right. */
  public double angleIncrement() {
    return get(ANGLE_INCREMENT).orElseThrow();
  }

  /**
   * Direction of each beam [rad] if unevenly spaced; startAngle and angleIncrement are then unused.
   */
  public List<Double> angles() {
    return get(ANGLES);
  }

  /** Range of each beam [m]; 0 and meaningless where returns is false. */
  public List<Double> ranges() {
    return get(RANGES);
  }

  /** Whether each beam returned an echo; one per range. */
  public List<Boolean> returns() {
    return get(RETURNS);
  }

  /**
   * Sets the beams of a sensor with equal angular steps.
   *
   * @param startAngle direction of the first beam [rad]
   * @param angleIncrement angle between beams [rad]
   * @param ranges in that order [m]; empty: no echo
   */
  public RangeScan beams(double startAngle, double angleIncrement, List<OptionalDouble> ranges) {
    put(START_ANGLE, startAngle);
    put(ANGLE_INCREMENT, angleIncrement);
    put(ANGLES, List.of());
    return measured(ranges);
  }

  /** Sets the beams of a sensor with unequal angular steps, in measuring order. */
  public RangeScan beams(List<Beam> beams) {
    List<Double> angles = new ArrayList<>(beams.size());
    List<OptionalDouble> ranges = new ArrayList<>(beams.size());
    for (Beam beam : beams) {
      angles.add(beam.angle());
      ranges.add(beam.range());
    }
    put(ANGLES, angles);
    return measured(ranges);
  }

  private RangeScan measured(List<OptionalDouble> measured) {
    List<Double> ranges = new ArrayList<>(measured.size());
    List<Boolean> returns = new ArrayList<>(measured.size());
    for (OptionalDouble range : measured) {
      ranges.add(range.orElse(0.0));
      returns.add(range.isPresent());
    }
    put(RANGES, ranges);
    return put(RETURNS, returns);
  }

  /** Number of beams that are complete; a faulty writer may leave lists of different lengths. */
  public int beamCount() {
    int count = Math.min(ranges().size(), returns().size());
    return angles().isEmpty() ? count : Math.min(count, angles().size());
  }

  /** All beams, in measuring order. */
  public List<Beam> beams() {
    List<Double> angles = angles();
    List<Double> ranges = ranges();
    List<Boolean> returns = returns();
    int count = beamCount();
    List<Beam> beams = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      double angle = angles.isEmpty() ? startAngle() + i * angleIncrement() : angles.get(i);
      beams.add(
          new Beam(
              angle, returns.get(i) ? OptionalDouble.of(ranges.get(i)) : OptionalDouble.empty()));
    }
    return beams;
  }

  /**
   * Echoes between minRange and maxRange as points in BODY.
   *
   * @throws IllegalStateException if the sensor's pose is not in BODY
   */
  public List<Point> points() {
    if (!referenceFrame().equals(ReferenceFrame.BODY)) {
      throw new IllegalStateException(
          "a scan in " + referenceFrame() + " has no points: expected " + ReferenceFrame.BODY);
    }
    // BODY is left-handed: rotations are done in FRD axes, where y, roll and yaw have opposite
    // sign.
    Rotation frd = Rotation.nedFromFrd(-phi(), theta(), -psi());
    Point place = Point.of(x(), y(), z());
    List<Point> points = new ArrayList<>();
    for (Beam beam : beams()) {
      double range = beam.range().orElse(-1.0);
      if (range >= minRange() && range <= maxRange()) {
        Point seen = Point.polar(-beam.angle(), 0.0, range); // FRD: positive to the right
        Point turned = frd.times(seen);
        points.add(Point.of(turned.x(), -turned.y(), turned.z()).plus(place));
      }
    }
    return points;
  }
}
