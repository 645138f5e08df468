package org.u2sa.vision.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.vision.ground.CameraMount;

/**
 * Geometry of one image of the ground, level or given by a height map, taken by a pinhole camera of
 * known pose. Immutable.
 *
 * <p>Camera axes are x ahead, y right, z down in the image.
 */
final class AerialView {
  private static final double HALF = Math.sqrt(0.5);
  private static final int LOOKS = 6; // iterations on terrain; enough for gentle slopes
  private static final double MIN_SINE = 0.2; // minimum sine of a ray's angle below the horizon

  private final Intrinsics lens;
  private final int width;
  private final int height;
  private final Geodetic camera;
  private final Rotation nedFromCamera;
  private final double groundM; // altitude of level ground
  private final Optional<HeightGrid> terrain;

  /**
   * @param state in GLOBAL, with altitude and attitude
   * @param groundM altitude of the ground above mean sea level where there is no terrain
   * @param terrain height map, if there is one
   */
  AerialView(
      CameraFrame frame,
      CameraMount mount,
      StateInformation state,
      double groundM,
      Optional<HeightGrid> terrain) {
    this.terrain = terrain;
    lens = frame.intrinsics().orElseThrow();
    width = frame.width();
    height = frame.height();
    this.groundM = groundM;
    Rotation nedFromFrd =
        new Attitude(
                state.phi().orElseThrow(), state.theta().orElseThrow(), state.psi().orElseThrow())
            .nedFromFrd();
    nedFromCamera = nedFromFrd.times(mount.turn());
    Geodetic vehicle =
        new Geodetic(state.x().orElseThrow(), state.y().orElseThrow(), state.z().orElseThrow());
    camera = vehicle.fromNed(nedFromFrd.times(mount.place()));
  }

  private Point ray(double column, double row) {
    return nedFromCamera.times(
        Point.of(
            1.0,
            (column - lens.centreX()) / lens.focalX(),
            (row - lens.centreY()) / lens.focalY()));
  }

  /** Position on the ground shown by a pixel; empty near and above the horizon. */
  Optional<Geodetic> ground(double column, double row) {
    Point ray = ray(column, row);
    if (ray.z() < MIN_SINE * ray.distance()) {
      return Optional.empty();
    }
    Optional<Geodetic> place = at(ray, groundM);
    for (int i = 0; i < LOOKS && terrain.isPresent() && place.isPresent(); i++) {
      place = at(ray, terrain.get().altitudeM(place.get()).orElse(groundM));
    }
    return place;
  }

  /** Point at which a ray reaches an altitude; empty if the camera is not above it. */
  private Optional<Geodetic> at(Point ray, double altitudeM) {
    double heightM = camera.altitudeM() - altitudeM;
    if (heightM <= 0.0) {
      return Optional.empty();
    }
    Point way = ray.times(heightM / ray.z());
    Geodetic flat = camera.fromNed(Point.of(way.x(), way.y(), 0.0));
    return Optional.of(new Geodetic(flat.longitudeDeg(), flat.latitudeDeg(), altitudeM));
  }

  /**
   * Ground resolution at a pixel, in the worse direction [m per pixel]: a pixel's angle cos²ε / f
   * away from the optical axis, spread by the slant of the ray; on terrain, from the positions of
   * neighbouring pixels.
   */
  double resolutionM(double column, double row) {
    if (terrain.isPresent()) {
      return Math.max(
          Math.max(apartM(column, row, 1.0, 0.0), apartM(column, row, 0.0, 1.0)),
          Math.max(apartM(column, row, HALF, HALF), apartM(column, row, HALF, -HALF)));
    }
    Point ray = ray(column, row);
    double length = ray.distance(); // 1 / cos ε
    double slant = (camera.altitudeM() - groundM) * length / ray.z();
    double along = slant / (length * length) / (ray.z() / length);
    double across = slant / length;
    return Math.max(along, across) / Math.min(lens.focalX(), lens.focalY());
  }

  /** Ground per pixel along a direction in the image [m]; infinite if it shows the horizon. */
  private double apartM(double column, double row, double right, double down) {
    double px = 4.0;
    Optional<Geodetic> one = ground(column - px * right, row - px * down);
    Optional<Geodetic> other = ground(column + px * right, row + px * down);
    if (one.isEmpty() || other.isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    return one.get().nedOf(other.get()).distance() / (2.0 * px);
  }

  /** Angle of a pixel's ray from the vertical [rad]. */
  double angleRad(double column, double row) {
    Point ray = ray(column, row);
    return Math.acos(Math.max(-1.0, Math.min(1.0, ray.z() / ray.distance())));
  }

  /** Direction on the ground of the image's upper edge, clockwise from north [rad]. */
  double upRad() {
    Point up = nedFromCamera.times(Point.of(0.0, 0.0, -1.0));
    return Math.atan2(up.y(), up.x());
  }

  /** The ground that the image shows; empty if it shows the horizon. */
  Optional<ImageFootprint> footprint(long image) {
    double[][] corners = {{0, 0}, {width - 1, 0}, {width - 1, height - 1}, {0, height - 1}};
    List<Point> outline = new ArrayList<>();
    double resolution = 0.0;
    double angle = 0.0;
    for (double[] corner : corners) {
      Optional<Geodetic> place = ground(corner[0], corner[1]);
      if (place.isEmpty()) {
        return Optional.empty();
      }
      outline.add(place.get().point());
      resolution = Math.max(resolution, resolutionM(corner[0], corner[1]));
      angle = Math.max(angle, angleRad(corner[0], corner[1]));
    }
    ImageFootprint shown =
        new ImageFootprint().image(image).resolution(resolution).angle(angle).points(outline);
    OptionalDouble altitude =
        terrain.isPresent() ? terrain.get().altitudeM(camera) : OptionalDouble.empty();
    shown.x(camera.longitudeDeg()).y(camera.latitudeDeg()).z(altitude.orElse(groundM));
    return Optional.of(shown);
  }
}
