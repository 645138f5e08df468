package org.u2sa.messages;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.schema.MessageType;

/**
 * Converts points between frames, given the vehicle's pose. Every point passes through the frame of
 * the vehicle's state, GLOBAL or LOCAL_NED, or through BODY_FRD if no position is needed.
 */
public final class PointConversion {
  private final ReferenceFrame source;
  private final ReferenceFrame target;
  private final UtmGrid sourceGrid; // null unless the source is UTM
  private final UtmGrid targetGrid; // null unless the target is UTM
  private final StateInformation vehicle; // in GLOBAL or LOCAL_NED; null if not needed or not given

  private PointConversion(ReferenceFrame source, ReferenceFrame target, StateInformation vehicle) {
    this.source = source;
    this.target = target;
    this.vehicle = vehicle;
    sourceGrid = source.isUtm() ? new UtmGrid(source) : null;
    targetGrid = target.isUtm() ? new UtmGrid(target) : null;
  }

  /**
   * Creates the conversion for a message.
   *
   * @param vehicle may be null if both frames are of the same family
   * @throws IllegalArgumentException naming both frames, if no conversion exists
   */
  static PointConversion of(
      MessageType<?> type, ReferenceFrame source, ReferenceFrame target, StateInformation vehicle) {
    String what = type.name() + " cannot be converted from " + source + " to " + target;
    boolean sameFamily =
        source.isBody() && target.isBody()
            || source.isLocal() && target.isLocal()
            || source.isEarth() && target.isEarth();
    if (sameFamily) {
      return new PointConversion(source, target, null);
    }
    if (!source.isBody() && !target.isBody()) {
      throw new IllegalArgumentException(what + ": a vehicle's state has no local origin");
    }
    ReferenceFrame fixed = source.isBody() ? target : source;
    if (vehicle == null || vehicle.referenceFrame().isBody()) {
      throw new IllegalArgumentException(what + ": the vehicle's position and heading are needed");
    }
    if (fixed.isEarth() != vehicle.referenceFrame().isEarth()) {
      throw new IllegalArgumentException(
          what + " by a vehicle's state in " + vehicle.referenceFrame());
    }
    StateInformation placed =
        vehicle.in(fixed.isEarth() ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_NED);
    if (!placed.x().isPresent() || !placed.y().isPresent() || !placed.psi().isPresent()) {
      throw new IllegalArgumentException(
          what + ": the vehicle's state lacks x, y or psi: " + placed);
    }
    return new PointConversion(source, target, placed);
  }

  Point convert(Point point) {
    if (source.equals(target)) {
      return point;
    }
    if (source.isBody()) {
      Point frd = flipped(point, source);
      return target.isBody() ? flipped(frd, target) : fromVehicle(frd);
    }
    if (target.isBody()) {
      return flipped(attitude().transposed().times(nedFromVehicle(point)), target);
    }
    return source.isLocal() ? point.axesExchanged() : toGrid(toPlace(point));
  }

  /**
   * Converts a horizontal direction, measured as each frame measures psi.
   *
   * @param at position in the source frame
   */
  public double heading(Point at, double psi) {
    double along = source.isEarth() ? Math.PI / 2.0 - psi : psi;
    Metric before = Metric.around(source, at);
    Point end = before.point(Point.of(Math.cos(along), Math.sin(along), 0.0));
    Point after = Metric.around(target, convert(at)).metres(convert(end));
    return AxisExchange.fullTurn(
        target.isEarth() ? Math.atan2(after.x(), after.y()) : Math.atan2(after.y(), after.x()));
  }

  /**
   * Rotates a vector, such as a velocity, into the axes of the target frame; in GLOBAL east, north,
   * up.
   *
   * @param at position in the source frame
   */
  Point vector(Point at, Point vector) {
    Point[] axes = axes(at);
    return Point.of(
        mix(axes[0].x(), axes[1].x(), axes[2].x(), vector),
        mix(axes[0].y(), axes[1].y(), axes[2].y(), vector),
        mix(axes[0].z(), axes[1].z(), axes[2].z(), vector));
  }

  /**
   * Standard deviations [m] of a position along the axes of the target frame: the source's, plus
   * the contribution of the vehicle's position and attitude when converting from or to BODY.
   * Correlations are dropped.
   *
   * @param at position in the source frame
   */
  Point positionSigma(Point at, Point sigma) {
    Point[] axes = axes(at);
    Point own =
        Point.of(
            root(axes[0].x(), axes[1].x(), axes[2].x(), sigma),
            root(axes[0].y(), axes[1].y(), axes[2].y(), sigma),
            root(axes[0].z(), axes[1].z(), axes[2].z(), sigma));
    if (source.isBody() == target.isBody()) {
      return own;
    }
    Point ned = source.isBody() ? attitude().times(flipped(at, source)) : nedFromVehicle(at);
    Point vehicles = VehicleUncertainty.of(vehicle).sigmaNed(ned);
    Point added =
        target.isBody()
            ? attitude().transposed().timesSigma(vehicles)
            : target.equals(ReferenceFrame.LOCAL_NED)
                ? vehicles
                : Point.of(vehicles.y(), vehicles.x(), vehicles.z());
    return Point.of(
        Math.hypot(own.x(), added.x()),
        Math.hypot(own.y(), added.y()),
        Math.hypot(own.z(), added.z()));
  }

  /** The source's axes at a position, as unit vectors in the target's axes. */
  private Point[] axes(Point at) {
    Metric before = Metric.around(source, at);
    Metric after = Metric.around(target, convert(at));
    Point[] axes = new Point[3];
    for (int i = 0; i < axes.length; i++) {
      Point metre = Point.of(i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0);
      Point turned = after.metres(convert(before.point(metre)));
      double length = turned.distance(); // a grid metre differs slightly from a ground metre
      axes[i] = Point.of(turned.x() / length, turned.y() / length, turned.z() / length);
    }
    return axes;
  }

  private static double mix(double x, double y, double z, Point v) {
    return x * v.x() + y * v.y() + z * v.z();
  }

  private static double root(double x, double y, double z, Point sigma) {
    return Point.of(x * sigma.x(), y * sigma.y(), z * sigma.z()).distance();
  }

  private Point fromVehicle(Point frd) {
    Point ned = attitude().times(frd);
    if (target.isEarth()) {
      return toGrid(vehiclePlace().fromNed(ned));
    }
    Point local = ned.plus(vehiclePosition());
    return target.equals(ReferenceFrame.LOCAL_NED) ? local : local.axesExchanged();
  }

  /** Converts a point of an earth-fixed frame to north, east and down from the vehicle. */
  private Point nedFromVehicle(Point point) {
    if (source.isEarth()) {
      return vehiclePlace().nedOf(toPlace(point));
    }
    Point local = source.equals(ReferenceFrame.LOCAL_NED) ? point : point.axesExchanged();
    return local.minus(vehiclePosition());
  }

  /** Absent roll and pitch count as 0. */
  private Rotation attitude() {
    return Rotation.nedFromFrd(
        vehicle.phi().orElse(0.0), vehicle.theta().orElse(0.0), vehicle.psi().getAsDouble());
  }

  private Geodetic vehiclePlace() {
    return Geodetic.of(vehiclePosition());
  }

  private Point vehiclePosition() {
    return StateTriple.POSITION.values(vehicle);
  }

  private Geodetic toPlace(Point point) {
    return sourceGrid == null ? Geodetic.of(point) : sourceGrid.place(point);
  }

  private Point toGrid(Geodetic place) {
    return targetGrid == null ? place.point() : targetGrid.grid(place);
  }

  /** Converts between BODY_FRD and a BODY frame, either way. */
  private static Point flipped(Point point, ReferenceFrame body) {
    BodySigns axes = BodySigns.of(body);
    return Point.of(point.x(), axes.y() * point.y(), axes.z() * point.z());
  }
}
