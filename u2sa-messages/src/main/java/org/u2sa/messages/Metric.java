package org.u2sa.messages;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Metric coordinates around a centre given in any frame: east, north, up in GLOBAL; the frame's own
 * axes otherwise.
 */
public interface Metric {
  /** Converts a point of the frame to metres from the centre. */
  Point metres(Point point);

  /** Converts metres from the centre to a point of the frame. */
  Point point(Point metres);

  static Metric around(ReferenceFrame frame, Point center) {
    return frame.equals(ReferenceFrame.GLOBAL)
        ? new OnEarth(Geodetic.of(center))
        : new OnPlane(center);
  }

  /** Creates metric coordinates around a geographic position. */
  record OnEarth(Geodetic center) implements Metric {
    @Override
    public Point metres(Point point) {
      return center.enuOf(Geodetic.of(point));
    }

    @Override
    public Point point(Point metres) {
      return center.fromEnu(metres).point();
    }
  }

  /** Creates metric coordinates around a point of Cartesian axes. */
  record OnPlane(Point center) implements Metric {
    @Override
    public Point metres(Point point) {
      return point.minus(center);
    }

    @Override
    public Point point(Point metres) {
      return center.plus(metres);
    }
  }
}
