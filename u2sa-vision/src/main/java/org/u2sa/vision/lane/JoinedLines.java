package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** Lines with closed gaps as one: dashes, and what is left of worn paint. */
final class JoinedLines {
  private final List<List<Point>> all = new ArrayList<>();
  private final List<List<Point>> parts;
  private final List<List<Point>> with; // what each part belongs to

  JoinedLines(List<List<Point>> lines) {
    parts = lines;
    with = new ArrayList<>(lines);
    all.addAll(lines);
  }

  /** Joins two lines by a curve from an end of one to an end of the other. */
  void join(LineEnd one, List<Point> curve, LineEnd other) {
    List<Point> first = with(one.line());
    List<Point> second = with(other.line());
    if (first == second) {
      return; // a ring is not longer than the line that it is made of
    }
    List<Point> joined = new ArrayList<>(first);
    if (joined.get(0) == one.at()) {
      Collections.reverse(joined);
    }
    joined.addAll(curve.subList(1, Math.max(1, curve.size() - 1)));
    List<Point> rest = new ArrayList<>(second);
    if (rest.get(0) != other.at()) {
      Collections.reverse(rest);
    }
    joined.addAll(rest);
    all.removeIf(line -> line == first || line == second);
    all.add(joined);
    with.replaceAll(line -> line == first || line == second ? joined : line);
  }

  /** All lines, as far as they are joined. */
  List<List<Point>> all() {
    return all;
  }

  /** What one of the lines is a part of. */
  List<Point> with(List<Point> line) {
    int part = 0;
    while (parts.get(part) != line) {
      part++;
    }
    return with.get(part);
  }
}
