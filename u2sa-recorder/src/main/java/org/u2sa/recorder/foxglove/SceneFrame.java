package org.u2sa.recorder.foxglove;

import java.util.Optional;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.frame.UtmGrid;

/**
 * Frames of the views, all right-handed and metric: {@code map} is east-north-up at the vehicle's
 * first position, {@code body} is the vehicle's forward-left-up, {@code local} is east-north-up in
 * local frames.
 */
public final class SceneFrame {
  public static final String MAP = "map";
  public static final String BODY = "body";
  public static final String LOCAL = "local";

  private Geodetic origin; // of the map; null until known

  /** A point in one of the frames. */
  public record Placed(String frame, Point point) {}

  /** Map coordinates of a global position; the first one becomes the origin. */
  public Point onMap(Geodetic place) {
    if (origin == null) {
      origin = place;
    }
    return origin.enuOf(place);
  }

  /**
   * Converts a point of a message's frame; empty for positions on the earth before the map has an
   * origin.
   */
  public Optional<Placed> place(ReferenceFrame frame, Point point) {
    if (frame.isEarth()) {
      Geodetic place = Geodetic.of(UtmGrid.global(frame, point));
      return Optional.ofNullable(origin).map(at -> new Placed(MAP, at.enuOf(place)));
    }
    if (frame.equals(ReferenceFrame.LOCAL_ENU)) {
      return Optional.of(new Placed(LOCAL, point));
    }
    if (frame.equals(ReferenceFrame.LOCAL_NED)) {
      return Optional.of(new Placed(LOCAL, Point.of(point.y(), point.x(), -point.z())));
    }
    if (frame.equals(ReferenceFrame.BODY)) { // axes of the thesis: z is down, y is left
      return Optional.of(new Placed(BODY, Point.of(point.x(), point.y(), -point.z())));
    }
    if (frame.equals(ReferenceFrame.BODY_FRD)) {
      return Optional.of(new Placed(BODY, Point.of(point.x(), -point.y(), -point.z())));
    }
    return Optional.of(new Placed(BODY, point)); // BODY_FLU
  }

  /**
   * Turn of a message's object about the up axis from the x axis of the frame it is placed in
   * [rad], counterclockwise seen from above. The convergence of a grid is neglected.
   *
   * @param psi heading in the message's frame [rad]
   */
  public static double turn(ReferenceFrame frame, double psi) {
    if (frame.isEarth() || frame.equals(ReferenceFrame.LOCAL_NED)) {
      return Math.PI / 2 - psi;
    }
    return frame.equals(ReferenceFrame.BODY_FRD) ? -psi : psi;
  }

  /**
   * Vehicle attitude in the map: rotates forward-left-up to east-north-up.
   *
   * @param phi roll, right wing down positive [rad]
   * @param theta pitch, nose up positive [rad]
   * @param psi heading, clockwise from north [rad]
   */
  static ProtobufMessage attitude(double phi, double theta, double psi) {
    Rotation ned = Rotation.nedFromFrd(phi, theta, psi);
    return quaternion(
        ned.times(Point.of(1.0, 0.0, 0.0)).axesExchanged(),
        ned.times(Point.of(0.0, -1.0, 0.0)).axesExchanged(),
        ned.times(Point.of(0.0, 0.0, -1.0)).axesExchanged());
  }

  private static ProtobufMessage quaternion(Point a, Point b, Point c) {
    double[] q = xyzw(a, b, c);
    return new ProtobufMessage().number(1, q[0]).number(2, q[1]).number(3, q[2]).number(4, q[3]);
  }

  /** Quaternion x, y, z, w of the rotation matrix with these columns (Shepperd 1978). */
  public static double[] xyzw(Point a, Point b, Point c) {
    double trace = a.x() + b.y() + c.z();
    double[] squares = {
      1 + a.x() - b.y() - c.z(), 1 - a.x() + b.y() - c.z(), 1 - a.x() - b.y() + c.z(), 1 + trace
    };
    int largest = 0;
    for (int i = 1; i < squares.length; i++) {
      largest = squares[i] > squares[largest] ? i : largest;
    }
    double r = Math.sqrt(squares[largest]);
    double s = 0.5 / r;
    return switch (largest) {
      case 0 -> new double[] {r / 2, (a.y() + b.x()) * s, (a.z() + c.x()) * s, (b.z() - c.y()) * s};
      case 1 -> new double[] {(a.y() + b.x()) * s, r / 2, (b.z() + c.y()) * s, (c.x() - a.z()) * s};
      case 2 -> new double[] {(a.z() + c.x()) * s, (b.z() + c.y()) * s, r / 2, (a.y() - b.x()) * s};
      default ->
          new double[] {(b.z() - c.y()) * s, (c.x() - a.z()) * s, (a.y() - b.x()) * s, r / 2};
    };
  }

  /** A {@code foxglove.Quaternion} about the up axis [rad], counterclockwise seen from above. */
  static ProtobufMessage aboutUp(double angle) {
    return new ProtobufMessage().number(3, Math.sin(angle / 2)).number(4, Math.cos(angle / 2));
  }

  /** A {@code foxglove.Vector3} or {@code Point3}. */
  static ProtobufMessage vector(Point point) {
    return new ProtobufMessage().number(1, point.x()).number(2, point.y()).number(3, point.z());
  }

  /** A {@code foxglove.Pose}. */
  static ProtobufMessage pose(Point position, ProtobufMessage quaternion) {
    return new ProtobufMessage().message(1, vector(position)).message(2, quaternion);
  }
}
