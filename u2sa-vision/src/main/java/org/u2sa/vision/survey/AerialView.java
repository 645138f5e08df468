package org.u2sa.vision.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.vision.ground.CameraMount;

/**
 * Geometry of one image of level ground, taken by a pinhole camera of known pose. Immutable.
 *
 * <p>Camera axes are x ahead, y right, z down in the image.
 */
final class AerialView {
  private static final double MIN_SINE = 0.2; // of a ray's angle below the horizon

  private final Intrinsics lens;
  private final int width;
  private final int height;
  private final Geodetic camera;
  private final Rotation nedFromCamera;
  private final double groundM; // altitude

  /**
   * @param state in GLOBAL, with altitude and attitude
   * @param groundM altitude of the ground above mean sea level
   */
  AerialView(CameraFrame frame, CameraMount mount, StateInformation state, double groundM) {
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

  /** Place on the ground that a pixel shows; empty near the horizon and above. */
  Optional<Geodetic> ground(double column, double row) {
    Point ray = ray(column, row);
    double heightM = camera.altitudeM() - groundM;
    if (heightM <= 0.0 || ray.z() < MIN_SINE * ray.distance()) {
      return Optional.empty();
    }
    Point way = ray.times(heightM / ray.z());
    Geodetic flat = camera.fromNed(Point.of(way.x(), way.y(), 0.0));
    return Optional.of(new Geodetic(flat.longitudeDeg(), flat.latitudeDeg(), groundM));
  }

  /**
   * Ground resolution at a pixel, in the worse direction [m per pixel]: a pixel's angle cos²ε / f
   * away from the optical axis, spread by the slant of the ray.
   */
  double resolutionM(double column, double row) {
    Point ray = ray(column, row);
    double length = ray.distance(); // 1 / cos ε
    double slant = (camera.altitudeM() - groundM) * length / ray.z();
    double along = slant / (length * length) / (ray.z() / length);
    double across = slant / length;
    return Math.max(along, across) / Math.min(lens.focalX(), lens.focalY());
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
    shown.x(camera.longitudeDeg()).y(camera.latitudeDeg()).z(groundM);
    return Optional.of(shown);
  }
}
