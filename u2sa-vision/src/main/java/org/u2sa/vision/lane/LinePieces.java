package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.world.modeller.MapFrame;

/** Converts lines to objects: short pieces, which are faster to search and draw. */
final class LinePieces {
  /** Confidence of a line seen from several viewpoints. */
  static final double CERTAIN = 1.0;

  /** Confidence of an inferred side of the lane that the vehicle has driven in. */
  static final double DRIVEN = 0.8;

  /** Confidence of a less certain piece that is near and runs along a lane. */
  static final double SIDE = 0.7;

  /** Confidence of any other inferred piece, which may wrongly cross a lane. */
  static final double GUESS = 0.5;

  private static final int POINTS_A_PIECE = 14;

  /**
   * Range of {@link #SIDE}. Lines farther away are seen so inaccurately that they may appear to
   * block a passage.
   */
  private static final double NEAR_M = 3.0;

  private final MapFrame frame;
  private final String type;
  private final Point vehicle;
  private final double clearM;
  private final List<ObjectDescription> all = new ArrayList<>();

  /**
   * @param vehicle vehicle position in metres from the map's anchor
   * @param clearM minimum distance of unseen pieces from the vehicle [m]
   */
  LinePieces(MapFrame frame, String type, Point vehicle, double clearM) {
    this.frame = frame;
    this.type = type;
    this.vehicle = vehicle;
    this.clearM = clearM;
  }

  List<ObjectDescription> all() {
    return all;
  }

  /** Adds a line that was seen from several viewpoints. */
  void certain(List<Point> line) {
    pieces(line).forEach(piece -> add(piece, CERTAIN));
  }

  /** Adds a line that was seen from few viewpoints. */
  void uncertain(List<Point> line, Predicate<List<Point>> isSide) {
    pieces(line).forEach(piece -> add(piece, confidence(piece, isSide)));
  }

  /** Adds a line inferred from others. */
  void inferred(List<Point> line, double confidence) {
    clear(line).forEach(part -> pieces(part).forEach(piece -> add(piece, confidence)));
  }

  /** Adds a line that may exist. */
  void guessed(List<Point> line, Predicate<List<Point>> isSide) {
    clear(line)
        .forEach(part -> pieces(part).forEach(piece -> add(piece, confidence(piece, isSide))));
  }

  /** Confidence of an uncertain piece: distant pieces stay tentative until seen from closer. */
  private double confidence(List<Point> piece, Predicate<List<Point>> isSide) {
    boolean near = piece.stream().anyMatch(at -> LineGeometry.metres(at, vehicle) < NEAR_M);
    return near && isSide.test(piece) ? SIDE : GUESS;
  }

  /** Parts of a line that are far enough from the vehicle. */
  private List<List<Point>> clear(List<Point> line) {
    List<List<Point>> parts = new ArrayList<>();
    List<Point> part = new ArrayList<>();
    for (Point point : line) {
      if (LineGeometry.metres(point, vehicle) >= clearM) {
        part.add(point);
      } else if (!part.isEmpty()) {
        parts.add(part);
        part = new ArrayList<>();
      }
    }
    parts.add(part);
    parts.removeIf(each -> each.size() < 2);
    return parts;
  }

  private static List<List<Point>> pieces(List<Point> line) {
    List<List<Point>> pieces = new ArrayList<>();
    for (int from = 0; from == 0 || from < line.size() - 1; from += POINTS_A_PIECE) {
      pieces.add(line.subList(from, Math.min(line.size(), from + POINTS_A_PIECE + 1)));
    }
    return pieces;
  }

  private void add(List<Point> piece, double confidence) {
    List<Point> points = piece.stream().map(frame::point).collect(Collectors.toList());
    PolyLine line = new PolyLine();
    line.points(points)
        .width(LineSamples.WIDTH_M)
        .uid("line " + (all.size() + 1))
        .objectType(type)
        .referenceFrame(frame.frame())
        .x(points.get(0).x())
        .y(points.get(0).y())
        .level(ObjectLevel.AVOID_ALWAYS)
        .confidence(confidence);
    all.add(line);
  }
}
