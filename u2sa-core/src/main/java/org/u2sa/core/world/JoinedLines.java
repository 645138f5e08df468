package org.u2sa.core.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Point;

/** Lines with closed gaps as one: dashes, and what is left of worn paint. */
final class JoinedLines {
  private final List<List<Point>> all = new ArrayList<>();
  private final Map<List<Point>, List<Point>> with = new IdentityHashMap<>(); // by each part

  JoinedLines(List<List<Point>> lines) {
    for (List<Point> line : lines) {
      all.add(line);
      with.put(line, line);
    }
  }

  /** Joins two lines by a curve from an end of one to an end of the other. */
  void join(LineEnd one, List<Point> curve, LineEnd other) {
    List<Point> first = with.get(one.line());
    List<Point> second = with.get(other.line());
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
    with.replaceAll((part, line) -> line == first || line == second ? joined : line);
  }

  /** All lines, as far as they are joined. */
  List<List<Point>> all() {
    return all;
  }

  /** What a line is a part of. */
  List<Point> with(List<Point> line) {
    return with.get(line);
  }
}
