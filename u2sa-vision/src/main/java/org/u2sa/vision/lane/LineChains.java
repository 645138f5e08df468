package org.u2sa.vision.lane;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.u2sa.messages.frame.Point;

/** Links samples into lines. Coordinates in metres from the map's anchor. */
record LineChains(List<List<Point>> lines, Set<List<Point>> sure) {
  private static final double LINK_M = 0.5; // maximum step between samples
  private static final double ASIDE = 0.7; // sine of the maximum angle between step and line
  private static final double SHORTEST_M = 0.5; // minimum length of a line
  private static final double LESS_SURE = 1.0 + 1e-9; // squares round differently from hypot
  private static final double VIEWS = 2.5; // minimum mean number of viewpoints of a sure line

  static LineChains of(List<LineSamples.Sample> samples) {
    int[][] next = new int[samples.size()][];
    Neighbours near = new Neighbours(samples);
    for (int i = 0; i < next.length; i++) {
      next[i] = new int[] {near.step(i, 1.0), near.step(i, -1.0)};
    }
    boolean[] strung = new boolean[next.length];
    List<List<Point>> lines = new ArrayList<>();
    Set<List<Point>> sure = new HashSet<>();
    for (int i = 0; i < next.length; i++) {
      if (!strung[i]) {
        List<LineSamples.Sample> string = string(i, samples, next, strung);
        List<Point> line = new ArrayList<>(string.size());
        string.forEach(sample -> line.add(Point.of(sample.x, sample.y, 0.0)));
        if (LineGeometry.lengthM(line) >= SHORTEST_M) {
          lines.add(line);
          double views = string.stream().mapToInt(sample -> sample.views).average().orElse(0.0);
          if (views >= VIEWS) {
            sure.add(line);
          }
        }
      }
    }
    return new LineChains(lines, sure);
  }

  /** Follows samples in both directions while they are mutual neighbours. */
  private static List<LineSamples.Sample> string(
      int from, List<LineSamples.Sample> samples, int[][] next, boolean[] strung) {
    List<LineSamples.Sample> line = new ArrayList<>();
    strung[from] = true;
    line.add(samples.get(from));
    for (int way = 0; way < 2; way++) {
      int before = from;
      int at = next[from][way];
      while (at >= 0 && !strung[at] && (next[at][0] == before || next[at][1] == before)) {
        strung[at] = true;
        line.add(samples.get(at));
        int on = next[at][0] == before ? next[at][1] : next[at][0];
        before = at;
        at = on;
      }
      Collections.reverse(line);
    }
    return line;
  }

  boolean isSure(List<Point> line) {
    return sure.contains(line);
  }

  /** Finds the next sample along a line. */
  private static final class Neighbours {
    private final List<LineSamples.Sample> samples;
    private final Integer[] byX;
    private final int[] rank;

    Neighbours(List<LineSamples.Sample> samples) {
      this.samples = samples;
      byX = new Integer[samples.size()];
      rank = new int[samples.size()];
      Arrays.setAll(byX, i -> i);
      Arrays.sort(byX, Comparator.comparingDouble((Integer i) -> samples.get(i).x));
      for (int i = 0; i < byX.length; i++) {
        rank[byX[i]] = i;
      }
    }

    /** Index of the nearest sample ahead (1) or behind (-1) that may follow; −1 if none. */
    int step(int from, double sign) {
      LineSamples.Sample sample = samples.get(from);
      int best = -1;
      double nearest = LINK_M;
      for (int way = -1; way <= 1; way += 2) {
        for (int k = rank[from] + way; k >= 0 && k < byX.length; k += way) {
          LineSamples.Sample other = samples.get(byX[k]);
          double x = other.x - sample.x;
          double y = other.y - sample.y;
          if (Math.abs(x) > nearest) {
            break;
          }
          double along = sign * (x * sample.dx + y * sample.dy);
          boolean parallel = Math.abs(sample.dx * other.dx + sample.dy * other.dy) > ASIDE;
          if (!parallel || along <= 0.02 || x * x + y * y > LESS_SURE * nearest * nearest) {
            continue; // without hypot, which is slow
          }
          double away = Math.hypot(x, y);
          double across = Math.abs(x * sample.dy - y * sample.dx);
          if (across <= ASIDE * away && away < nearest) {
            best = byX[k];
            nearest = away;
          }
        }
      }
      return best;
    }
  }
}
