package org.u2sa.vision.ground;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.lens.LensCalibration.Spot;

/**
 * Projection between one image and the ground: a horizontal plane below the vehicle, seen by a
 * camera of known geometry and mounting while the vehicle rolls and pitches (Hartley and Zisserman,
 * 2nd ed., section 8.1.1: the homography of a plane, here by rays so that distortion is exact).
 *
 * <p>Ground positions are in LEVEL axes: x forward along the heading, y right, z down, from the
 * vehicle's reference point; {@link #toBody} converts them to BODY. Immutable.
 */
public final class GroundView {
  private static final double HORIZON = 1e-3; // sine of the minimum angle below the horizon

  private final LensCalibration lens;
  private final Rotation levelFromBody;
  private final Rotation bodyFromLevel;
  private final double groundZ;
  private final double[] place; // camera position, LEVEL
  private final double[] ahead; // the camera's axes in LEVEL
  private final double[] right;
  private final double[] down;
  private final double reach;

  /**
   * @param rollRad roll of the vehicle, right side down positive
   * @param pitchRad pitch of the vehicle, front up positive
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

  public LensCalibration lens() {
    return lens;
  }

  /** Current height of the camera above the ground [m]. */
  public double heightM() {
    return groundZ - place[2];
  }

  /** Camera position, LEVEL [m]. */
  public Point camera() {
    return Point.of(place[0], place[1], place[2]);
  }

  /** Intersection of a pixel's ray with the ground, LEVEL; empty at and above the horizon. */
  public Optional<Point> ground(double column, double row) {
    return atHeight(column, row, 0.0);
  }

  /**
   * Intersection of a pixel's ray with a height above the ground [m], LEVEL; empty if there is
   * none.
   */
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

  /** Direction of a pixel's ray, LEVEL, not normalised; empty beyond the lens's field of view. */
  public Optional<Point> ray(double column, double row) {
    return lens.place(column, row).map(this::direction);
  }

  private Point direction(Spot seen) {
    return Point.of(
        ahead[0] + seen.x() * right[0] + seen.y() * down[0],
        ahead[1] + seen.x() * right[1] + seen.y() * down[1],
        ahead[2] + seen.x() * right[2] + seen.y() * down[2]);
  }

  /** Pixel of a position in LEVEL; empty behind the camera and outside the field of view. */
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

  public Point onGround(double forward, double toRight) {
    return Point.of(forward, toRight, groundZ);
  }

  /** Converts from LEVEL to BODY: x forward, y left, z down, fixed to the vehicle. */
  public Point toBody(Point level) {
    Point frd = bodyFromLevel.times(level);
    return Point.of(frd.x(), -frd.y(), frd.z());
  }

  public Point toLevel(Point body) {
    return levelFromBody.times(Point.of(body.x(), -body.y(), body.z()));
  }

  /** Coefficients for {@link TopView} to step through cells without allocating. */
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
