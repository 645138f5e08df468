package org.u2sa.scenarios.vrx;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Sphere;

/**
 * The 2022 dock: three bays that open towards its −x, and a light buoy that shows a sequence of
 * three colours. Dimensions are those of VRX's models dock_2022 and dock_2022_base.
 *
 * @param place position of the dock: east, north [m]
 * @param yawRad direction of its x axis, anticlockwise from east
 * @param sequence colours of the light buoy
 * @param light position of the light buoy: east, north [m]
 * @param points awarded
 * @param stayS time to stay in a bay [s]
 */
record Docking(
    Point place,
    double yawRad,
    List<Bay> bays,
    List<Colour> sequence,
    Point light,
    Points points,
    double stayS) {
  /** Type of the light buoy. */
  static final String LIGHT = "light buoy";

  /** Type of the blocks that the dock is built of. */
  static final String BLOCK = "dock block";

  private static final double BAY_M = 6.0; // spacing
  private static final double FIRST_M = 3.0;
  private static final double[] INSIDE = {-0.5, 3.5, 0.75}; // x from, x to, half of y [m]
  private static final double[] ENTRANCE = {-4.25, -2.75, 2.75};
  private static final double SIGN_X_M = 5.68;
  private static final double BOARD_X_M = 5.95;
  private static final double BOARD_WIDTH_M = 2.0;
  private static final double BOARD_THICKNESS_M = 0.5;
  private static final double BOARD_HEIGHT_M = 3.0;
  private static final double SIGN_Z_M = 1.5;

  /** Points for the colour sequence, for docking, and for docking in the right bay. */
  record Points(double sequence, double dock, double rightBay) {}

  /**
   * A bay.
   *
   * @param shape shape of its sign: circle, cross, triangle or rectangle
   * @param isRight whether the sequence designates it
   */
  record Bay(Colour colour, String shape, boolean isRight) {
    /** Type that a detector reports for its sign, such as "red circle". */
    String sign() {
      return colour.name().toLowerCase(Locale.ROOT) + " " + shape;
    }
  }

  /** No dock, for other tasks. */
  static Docking none() {
    return new Docking(
        Point.ORIGIN, 0.0, List.of(), List.of(), Point.ORIGIN, new Points(0.0, 0.0, 0.0), 0.0);
  }

  /** Maximum score. */
  double most() {
    return points.sequence + points.dock + points.rightBay;
  }

  /** Whether the boat's origin is inside a bay. */
  boolean isInside(int bay, Point at) {
    return isIn(INSIDE, bay, at);
  }

  /** Whether the boat's origin is in front of a bay. */
  boolean isBefore(int bay, Point at) {
    return isIn(ENTRANCE, bay, at);
  }

  private boolean isIn(double[] zone, int bay, Point at) {
    double east = at.x() - place.x();
    double north = at.y() - place.y();
    double x = east * Math.cos(yawRad) + north * Math.sin(yawRad);
    double y = north * Math.cos(yawRad) - east * Math.sin(yawRad);
    return x >= zone[0] && x <= zone[1] && Math.abs(y - middleM(bay)) <= zone[2];
  }

  private static double middleM(int bay) {
    return FIRST_M + BAY_M * bay;
  }

  /** Blocks of the fingers and the back, boards and their signs, in LOCAL_ENU. */
  List<ObjectDescription> objects() {
    List<ObjectDescription> all = new ArrayList<>();
    for (int row = 0; bays.size() > 0 && row < 4; row++) {
      for (int column = 0; column < 10; column++) {
        if (row == 3 || column % 3 == 0) {
          String name = "dock_block_" + row + "_" + column;
          all.add(block(name, 2.0 * row, 2.0 * column));
        }
      }
    }
    for (int i = 0; i < bays.size(); i++) {
      Box board =
          new Box()
              .length(BOARD_THICKNESS_M)
              .width(BOARD_WIDTH_M)
              .height(BOARD_HEIGHT_M)
              .psi(yawRad);
      all.add(at(board, "board_" + (i + 1), "", BOARD_X_M, middleM(i), SIGN_Z_M));
      Sphere sign = new Sphere().radius(0.01);
      String name = "sign_" + (i + 1);
      all.add(at(sign, name, bays.get(i).sign(), SIGN_X_M, middleM(i), SIGN_Z_M));
    }
    return all;
  }

  private ObjectDescription block(String name, double x, double y) {
    Box block = new Box().length(2.0).width(2.0).height(0.4).psi(yawRad);
    return at(block, name, BLOCK, x, y, 0.25);
  }

  private ObjectDescription at(
      ObjectDescription object, String name, String type, double x, double y, double z) {
    object.uid(name).objectType(type).referenceFrame(ReferenceFrame.LOCAL_ENU);
    object.x(place.x() + x * Math.cos(yawRad) - y * Math.sin(yawRad));
    object.y(place.y() + x * Math.sin(yawRad) + y * Math.cos(yawRad));
    object.z(z);
    object.freeze();
    return object;
  }
}
