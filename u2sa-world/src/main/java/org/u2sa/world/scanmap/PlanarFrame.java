package org.u2sa.world.scanmap;

import java.util.Optional;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;

/**
 * The map's horizontal axes: east and north in GLOBAL and LOCAL_ENU, where angles turn
 * counter-clockwise from east; north and east in LOCAL_NED, where they turn clockwise from north.
 */
final class PlanarFrame {
  private final MapFrame map;
  private final boolean eastFirst;

  PlanarFrame(MapFrame map) {
    this.map = map;
    eastFirst = map.up() > 0.0;
  }

  /** Pose of a state in this map. */
  Pose2 pose(StateInformation vehicle) {
    Point place = map.vehicle(Optional.of(vehicle));
    Point nose = map.mapFromFrd(Optional.of(vehicle)).times(Point.of(1.0, 0.0, 0.0));
    return new Pose2(place.x(), place.y(), StrictMath.atan2(nose.y(), nose.x()));
  }

  /** Pose of a state in a local frame, in axes like the map's. */
  Pose2 local(StateInformation state) {
    StateInformation ned = state.in(ReferenceFrame.LOCAL_NED);
    double north = ned.x().orElseThrow();
    double east = ned.y().orElseThrow();
    return ofNed(north, east, ned.psi().orElseThrow());
  }

  /** Pose given by north, east [m] and heading [rad]. */
  Pose2 ofNed(double north, double east, double psi) {
    return eastFirst
        ? new Pose2(east, north, Pose2.wrapped(Math.PI / 2.0 - psi))
        : new Pose2(north, east, Pose2.wrapped(psi));
  }

  /** Covariance from a state's standard deviations. */
  static double[] covariance(StateInformation vehicle) {
    return Matrix3.ofSigmas(
        vehicle.number(StateField.X_SIGMA).orElse(0.0),
        vehicle.number(StateField.Y_SIGMA).orElse(0.0),
        vehicle.number(StateField.PSI_SIGMA).orElse(0.0));
  }

  /** Copy of a state at another pose. */
  StateInformation moved(StateInformation vehicle, Pose2 pose) {
    StateInformation state = vehicle.in(map.frame()).copy();
    Point metres = Point.of(pose.x(), pose.y(), map.vehicle(Optional.of(vehicle)).z());
    Point place = map.point(metres);
    return state.x(place.x()).y(place.y()).psi(psi(pose));
  }

  /**
   * Measurement of a pose. A state cannot carry the correlation of x and y, so the variances are
   * inflated to enclose the ellipse: in an oblique corridor both axes are as uncertain as the
   * direction along it.
   */
  StateInformation measurement(Pose2 pose, double[] covariance, double z) {
    Point place = map.point(Point.of(pose.x(), pose.y(), z));
    double both = Math.abs(covariance[1]);
    return new StateInformation()
        .referenceFrame(map.frame())
        .x(place.x())
        .y(place.y())
        .psi(psi(pose))
        .number(StateField.X_SIGMA, Math.sqrt(covariance[0] + both))
        .number(StateField.Y_SIGMA, Math.sqrt(covariance[4] + both))
        .number(StateField.PSI_SIGMA, Math.sqrt(covariance[8]));
  }

  private double psi(Pose2 pose) {
    double psi =
        map.frame().equals(ReferenceFrame.GLOBAL) ? Math.PI / 2.0 - pose.theta() : pose.theta();
    double turn = Pose2.wrapped(psi);
    return map.frame().equals(ReferenceFrame.LOCAL_ENU) || turn >= 0.0
        ? turn
        : turn + 2.0 * Math.PI;
  }
}
