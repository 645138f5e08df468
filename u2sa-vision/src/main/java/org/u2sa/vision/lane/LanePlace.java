package org.u2sa.vision.lane;

import org.u2sa.messages.frame.Point;

/** A past vehicle position, and the lane there. */
final class LanePlace {
  final Point at;
  final boolean begins; // not connected to the previous position
  final Side left = new Side();
  final Side right = new Side();
  boolean isLane; // both lines are seen, at a lane's width

  LanePlace(Point at, boolean begins) {
    this.at = at;
    this.begins = begins;
  }

  Side side(double sign) {
    return sign > 0.0 ? left : right;
  }

  /** Sets both sides; an unseen one follows from the lane's width or keeps its distance. */
  void set(double widthM, LanePlace before) {
    boolean inLane = !Double.isNaN(widthM) && before != null;
    for (double sign = 1.0; sign >= -1.0; sign -= 2.0) {
      Side side = side(sign);
      double otherM = side(-sign).seenM;
      double heldM = inLane ? before.side(sign).awayM : Double.NaN;
      double inferredM = Double.isNaN(otherM) ? heldM : widthM - otherM;
      side.awayM = isLane || inLane && !Double.isNaN(side.seenM) ? side.seenM : inferredM;
    }
  }

  /** Sets both sides by interpolation between two positions where both lines are seen. */
  void between(LanePlace one, LanePlace other, double share) {
    double widthM = 0.0;
    for (double sign = 1.0; sign >= -1.0; sign -= 2.0) {
      Side side = side(sign);
      double fromM = one.side(sign).seenM;
      side.awayM = fromM + share * (other.side(sign).seenM - fromM);
      widthM += side.awayM;
    }
    double leftM = left.seenM;
    double rightM = right.seenM;
    if (leftM < widthM && Double.isNaN(rightM)) {
      left.awayM = leftM;
      right.awayM = widthM - leftM;
    } else if (Double.isNaN(leftM) && rightM < widthM) {
      left.awayM = widthM - rightM;
      right.awayM = rightM;
    }
  }

  /** Whether the vehicle has crossed an inferred side and so left the lane. */
  boolean isOutside() {
    return left.awayM <= 0.0 || right.awayM <= 0.0;
  }

  /** Whether both sides of the lane are known, seen or inferred. */
  boolean hasSides() {
    return !Double.isNaN(left.awayM + right.awayM);
  }

  static final class Side {
    double seenM = Double.NaN; // distance of the seen line
    boolean sure; // whether that line is certain
    double awayM = Double.NaN; // distance of the side, seen or inferred
  }
}
