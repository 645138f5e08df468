package org.u2sa.messages;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Metres around a centre, whatever frame that is written in: in GLOBAL east, north, up; else the
 * frame's own axes.
 */
public interface Metric {
  /** A point of the frame as metres from the centre. */
  Point metres(Point point);

  /** Metres from the centre as a point of the frame. */
  Point point(Point metres);

  static Metric around(ReferenceFrame frame, Point center) {
    return frame.equals(ReferenceFrame.GLOBAL)
        ? new OnEarth(Geodetic.of(center))
        : new OnPlane(center);
  }

  /** Around a place on the earth. */
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

  /** Around a point of Cartesian axes. */
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
