package org.u2sa.world.grid;

import java.util.Arrays;
import org.u2sa.messages.RangeScan;

/**
 * How far each beam of a scan shows that nothing is there [m]. Neighbouring echoes may be of one
 * surface, so a beam is free only up to a margin before the line from its end to the end of each
 * neighbour: at a grazing angle, a beam's end lies far behind that of the next beam, and the
 * surface between them. A beam without an echo is free no further than the scanner has ever seen
 * anything: its reach may be less than it claims, and a dark or smooth surface returns nothing.
 */
final class FreeRanges {
  private static final double TINY = 1e-9; // two beams in one direction [m]

  private final BeamDirections directions = new BeamDirections();
  private double farthest; // echo of this scanner so far [m]
  private double[] ends = {}; // of each beam [m]; 0: says nothing
  private double[] free = {}; // beside each beam [m]
  private double[] slants = {0.0}; // of each beam and the one before
  private boolean[] echoes = {};
  private int beams;

  /** Begins a scan with so many beams. */
  void begin(RangeScan scan, int count) {
    directions.of(scan, count);
    beams = count;
    if (count > ends.length) {
      ends = new double[count];
      free = new double[count];
      slants = new double[count + 1];
      echoes = new boolean[count];
    }
    Arrays.fill(ends, 0, count, 0.0);
  }

  BeamDirections directions() {
    return directions;
  }

  /** A beam ended at an obstacle. */
  void echo(int beam, double range) {
    echoes[beam] = true;
    ends[beam] = range;
    farthest = Math.max(farthest, range);
  }

  /**
   * A beam ended at something that is no obstacle.
   *
   * @param measured range of that [m]
   * @param range how far at most it says that there is no obstacle [m]
   */
  void harmless(int beam, double measured, double range) {
    farthest = Math.max(farthest, measured);
    noEcho(beam, range);
  }

  /**
   * A beam met no obstacle.
   *
   * @param range how far at most it says so [m]; 0: it says nothing
   */
  void noEcho(int beam, double range) {
    echoes[beam] = false;
    ends[beam] = range;
  }

  /**
   * Ends a scan of which all beams are known.
   *
   * @param margin before an echo, and before the line between two, for what lies between beams [m]
   */
  void cut(double margin) {
    for (int i = 0; i < beams; i++) {
      if (!echoes[i]) {
        boolean dropped = i > 0 && i + 1 < beams && echoes[i - 1] && echoes[i + 1];
        double seen = dropped ? Math.max(ends[i - 1], ends[i + 1]) : farthest;
        ends[i] = Math.min(ends[i], seen);
      }
    }
    slants[0] = 0.0;
    slants[beams] = 0.0;
    for (int i = 1; i < beams; i++) {
      slants[i] = slant(i);
    }
    for (int i = 0; i < beams; i++) {
      free[i] = of(i, margin);
    }
  }

  /**
   * Of the line between the ends of a beam and of the one before: one over its distance from the
   * scanner; 0 if these cannot be of one surface.
   */
  private double slant(int beam) {
    double one = ends[beam - 1];
    double two = ends[beam];
    double cos = directions.gapCos(beam);
    if (!(echoes[beam - 1] || echoes[beam]) || one == 0.0 || two == 0.0 || cos <= 0.0) {
      return 0.0;
    }
    double product = one * two;
    double line = Math.sqrt(Math.max(0.0, one * one + two * two - 2.0 * product * cos));
    return line / Math.max(TINY, product * directions.gapSin(beam));
  }

  /** Free length of a beam [m], with the margin of {@link #cut}. */
  double of(int beam) {
    return free[beam];
  }

  /**
   * Free length of a beam [m].
   *
   * @param margin before an echo, and before the line between two [m]
   */
  double of(int beam, double margin) {
    double end = ends[beam];
    double range = echoes[beam] ? end - margin : end;
    if (slants[beam] > 0.0) {
      range = Math.min(range, before(end, ends[beam - 1], slants[beam], margin));
    }
    if (slants[beam + 1] > 0.0) {
      range = Math.min(range, before(end, ends[beam + 1], slants[beam + 1], margin));
    }
    return Math.max(0.0, range);
  }

  /** Where a beam comes as near as the margin to a line, but never less than a nearer end. */
  private static double before(double own, double other, double slant, double margin) {
    return Math.max(own - margin * own * slant, Math.min(own, other) - margin);
  }

  /**
   * Up to where all between a beam and the one before is free [m]: not beyond where the two are a
   * cell apart, as small things fit between them.
   */
  double between(int beam, double cell) {
    double both = Math.min(free[beam], free[beam - 1]);
    double apart = directions.apart(beam);
    return both * apart <= cell ? both : cell / apart;
  }
}
