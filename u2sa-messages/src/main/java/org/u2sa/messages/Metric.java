package org.u2sa.messages;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Metres around an object's centre, whatever frame the object is written in. */
interface Metric {
  /** A point of the object's frame as metres from its centre. */
  Point metres(Point point);

  static Metric of(ReferenceFrame frame, Point center) {
    if (frame.equals(ReferenceFrame.GLOBAL)) {
      Geodetic middle = Geodetic.of(center);
      return point -> middle.enuOf(Geodetic.of(point));
    }
    return point -> point.minus(center);
  }
}
