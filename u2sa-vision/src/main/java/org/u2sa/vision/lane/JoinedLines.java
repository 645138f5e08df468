package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** Merges lines whose gaps were closed: dashes and remains of worn paint. */
final class JoinedLines {
  private final List<List<Point>> all = new ArrayList<>();
  private final List<List<Point>> parts;
  private final List<List<Point>> with; // joined line of each part

  JoinedLines(List<List<Point>> lines) {
    parts = lines;
    with = new ArrayList<>(lines);
    all.addAll(lines);
  }

  /** Joins two lines with a curve between two of their ends. */
  void join(LineEnd one, List<Point> curve, LineEnd other) {
    List<Point> first = with(one.line());
    List<Point> second = with(other.line());
    if (first == second) {
      return; // closing a ring does not extend the line
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

  /** All lines after joining. */
  List<List<Point>> all() {
    return all;
  }

  /** Joined line that contains this line. */
  List<Point> with(List<Point> line) {
    int part = 0;
    while (parts.get(part) != line) {
      part++;
    }
    return with.get(part);
  }
}
