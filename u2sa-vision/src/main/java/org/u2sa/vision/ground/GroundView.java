package org.u2sa.vision.ground;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.lens.LensCalibration.Spot;

/**
 * One picture's way to the ground and back: a plane below the vehicle, level by gravity, seen by a
 * camera of known geometry and mounting while the vehicle rolls and pitches (Hartley and Zisserman,
 * 2nd ed., section 8.1.1: the homography of a plane, here as rays so that distortion is exact).
 *
 * <p>Places on the ground are in LEVEL axes: x forward along the heading, y right, z down, from the
 * vehicle's reference point; {@link #toBody} takes them to BODY. Immutable.
 */
public final class GroundView {
  private static final double HORIZON = 1e-3; // sine of the least angle below the horizon

  private final LensCalibration lens;
  private final Rotation levelFromBody;
  private final Rotation bodyFromLevel;
  private final double groundZ;
  private final double[] place; // of the camera, LEVEL
  private final double[] ahead; // the camera's axes in LEVEL
  private final double[] right;
  private final double[] down;
  private final double reach;

  /**
   * @param rollRad of the vehicle, right side down positive
   * @param pitchRad of the vehicle, front up positive
   */
  public GroundView(LensCalibration lens, CameraMount mount, double rollRad, double pitchRad) {
    this.lens = lens;
    reach = lens.reach();
    levelFromBody = Rotation.nedFromFrd(rollRad, pitchRad, 0.0);
    bodyFromLevel = levelFromBody.transposed();
    groundZ = mount.groundBelowM();
    Rotation turn = levelFromBody.times(mount.turn());
    place = numbers(levelFromBody.times(mount.place()));
    ahead = numbers(turn.times(Point.of(1.0, 0.0, 0.0)));
    right = numbers(turn.times(Point.of(0.0, 1.0, 0.0)));
    down = numbers(turn.times(Point.of(0.0, 0.0, 1.0)));
  }

  private static double[] numbers(Point point) {
    return new double[] {point.x(), point.y(), point.z()};
  }

  /** The camera's geometry. */
  public LensCalibration lens() {
    return lens;
  }

  /** Height of the camera above the ground now [m]. */
  public double heightM() {
    return groundZ - place[2];
  }

  /** Place of the camera, LEVEL [m]. */
  public Point camera() {
    return Point.of(place[0], place[1], place[2]);
  }

  /** Where a pixel's ray meets the ground, LEVEL; empty at and above the horizon. */
  public Optional<Point> ground(double column, double row) {
    return atHeight(column, row, 0.0);
  }

  /** Where a pixel's ray is at a height above the ground [m], LEVEL; empty if it never is. */
  public Optional<Point> atHeight(double column, double row, double heightM) {
    Optional<Spot> seen = lens.place(column, row);
    if (!seen.isPresent()) {
      return Optional.empty();
    }
    Point ray = direction(seen.get());
    double drop = groundZ - heightM - place[2];
    double sine = ray.z() / ray.distance();
    if (Math.abs(sine) < HORIZON || drop * sine <= 0.0) {
      return Optional.empty();
    }
    double times = drop / ray.z();
    return Optional.of(
        Point.of(
            place[0] + times * ray.x(), place[1] + times * ray.y(), place[2] + times * ray.z()));
  }

  /** The direction of a pixel's ray, LEVEL, of any length; empty where the lens shows nothing. */
  public Optional<Point> ray(double column, double row) {
    return lens.place(column, row).map(this::direction);
  }

  private Point direction(Spot seen) {
    return Point.of(
        ahead[0] + seen.x() * right[0] + seen.y() * down[0],
        ahead[1] + seen.x() * right[1] + seen.y() * down[1],
        ahead[2] + seen.x() * right[2] + seen.y() * down[2]);
  }

  /** The pixel at which a place is seen, LEVEL; empty behind the camera and beyond the lens. */
  public Optional<Spot> pixel(Point level) {
    double x = level.x() - place[0];
    double y = level.y() - place[1];
    double z = level.z() - place[2];
    double depth = x * ahead[0] + y * ahead[1] + z * ahead[2];
    if (depth <= 1e-6) {
      return Optional.empty();
    }
    double across = (x * right[0] + y * right[1] + z * right[2]) / depth;
    double below = (x * down[0] + y * down[1] + z * down[2]) / depth;
    return across * across + below * below > reach * reach
        ? Optional.empty()
        : Optional.of(lens.pixel(across, below));
  }

  /** A place on the ground, LEVEL. */
  public Point onGround(double forward, double toRight) {
    return Point.of(forward, toRight, groundZ);
  }

  /** From LEVEL to BODY: x forward, y left, z down, turned with the vehicle. */
  public Point toBody(Point level) {
    Point frd = bodyFromLevel.times(level);
    return Point.of(frd.x(), -frd.y(), frd.z());
  }

  /** From BODY to LEVEL. */
  public Point toLevel(Point body) {
    return levelFromBody.times(Point.of(body.x(), -body.y(), body.z()));
  }

  /** What {@link TopView} needs to step through cells without an object for each. */
  double[] cameraFrom(double forward, double toRight) {
    double x = forward - place[0];
    double y = toRight - place[1];
    double z = groundZ - place[2];
    return new double[] {
      x * ahead[0] + y * ahead[1] + z * ahead[2],
      x * right[0] + y * right[1] + z * right[2],
      x * down[0] + y * down[1] + z * down[2],
      ahead[1],
      right[1],
      down[1]
    };
  }
}
