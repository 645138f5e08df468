package org.u2sa.planning.survey;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.planning.curve.Dubins;
import org.u2sa.planning.curve.Pose;

/**
 * Chooses the order and directions of lanes: the nearest next lane by Dubins paths, then improved
 * by reversing parts of the sequence (2-opt: Croes, A Method for Solving Traveling-Salesman
 * Problems, Operations Research 6, 1958).
 */
final class LaneOrder {
  private static final int MAX_IMPROVED = 80; // lanes
  private static final int MAX_ROUNDS = 20;
  private static final double MIN_M = 0.1;

  private final List<Lane> both = new ArrayList<>(); // lane i in both directions: 2 i, 2 i + 1
  private final double[][] wayM; // from the end of one to the entry of another
  private final double[] firstM; // measured from the vehicle

  private LaneOrder(List<Lane> lanes, Pose start, double radiusM, double leadInM) {
    for (Lane lane : lanes) {
      both.add(lane);
      both.add(lane.reversed());
    }
    int count = both.size();
    wayM = new double[count][count];
    firstM = new double[count];
    for (int to = 0; to < count; to++) {
      Pose entry = both.get(to).entry(leadInM);
      firstM[to] = wayM(start, entry, radiusM);
      for (int from = 0; from < count; from++) {
        wayM[from][to] =
            from / 2 == to / 2
                ? Double.POSITIVE_INFINITY
                : wayM(both.get(from).end(), entry, radiusM);
      }
    }
  }

  /** Without a radius, the vehicle turns in place and flies straight. */
  private static double wayM(Pose from, Pose to, double radiusM) {
    return radiusM > 0.0
        ? Dubins.shortest(from, to, radiusM).lengthM()
        : from.distanceM(to.northM(), to.eastM());
  }

  static List<Lane> of(List<Lane> lanes, Pose start, double radiusM, double leadInM) {
    LaneOrder order = new LaneOrder(lanes, start, radiusM, leadInM);
    int[] sequence = order.nearest(lanes.size());
    if (lanes.size() <= MAX_IMPROVED) {
      order.improve(sequence);
    }
    List<Lane> ordered = new ArrayList<>();
    for (int each : sequence) {
      ordered.add(order.both.get(each));
    }
    return ordered;
  }

  private int[] nearest(int count) {
    int[] sequence = new int[count];
    boolean[] taken = new boolean[count];
    for (int i = 0; i < count; i++) {
      int best = -1;
      double least = Double.POSITIVE_INFINITY;
      for (int to = 0; to < 2 * count; to++) {
        double way = i == 0 ? firstM[to] : wayM[sequence[i - 1]][to];
        if (!taken[to / 2] && way < least) {
          least = way;
          best = to;
        }
      }
      sequence[i] = best;
      taken[best / 2] = true;
    }
    return sequence;
  }

  private double before(int[] sequence, int index, int lane) {
    return index == 0 ? firstM[lane] : wayM[sequence[index - 1]][lane];
  }

  /** Length of the ways within and around a part, flown as is or in reverse [m]. */
  private double partM(int[] sequence, int first, int last, boolean reverse) {
    double sum = before(sequence, first, reverse ? sequence[last] ^ 1 : sequence[first]);
    for (int i = first; i < last; i++) {
      sum +=
          reverse ? wayM[sequence[i + 1] ^ 1][sequence[i] ^ 1] : wayM[sequence[i]][sequence[i + 1]];
    }
    int end = reverse ? sequence[first] ^ 1 : sequence[last];
    return last + 1 < sequence.length ? sum + wayM[end][sequence[last + 1]] : sum;
  }

  private void improve(int[] sequence) {
    boolean better = true;
    for (int round = 0; better && round < MAX_ROUNDS; round++) {
      better = false;
      for (int first = 0; first < sequence.length; first++) {
        for (int last = first; last < sequence.length; last++) {
          double gain = partM(sequence, first, last, false) - partM(sequence, first, last, true);
          if (gain > MIN_M) {
            reverse(sequence, first, last);
            better = true;
          }
        }
      }
    }
  }

  private static void reverse(int[] sequence, int first, int last) {
    for (int i = first, j = last; i <= j; i++, j--) {
      int swapped = sequence[i];
      sequence[i] = sequence[j] ^ 1;
      sequence[j] = swapped ^ 1;
    }
  }
}
