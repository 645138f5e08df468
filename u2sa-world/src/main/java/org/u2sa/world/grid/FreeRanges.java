package org.u2sa.world.grid;

import java.util.Arrays;
import org.u2sa.messages.RangeScan;

/**
 * Range over which each beam of a scan proves free space [m]. Neighbouring echoes may lie on one
 * surface, so a beam is free only up to a margin before the line between its end and each
 * neighbour's end: at grazing angles, a beam may end far behind the next one, with the surface in
 * between. A beam without an echo is free no further than the scanner's farthest echo so far: its
 * actual range may be less than specified, and dark or smooth surfaces return no echo.
 */
final class FreeRanges {
  private static final double TINY = 1e-9; // beams in the same direction [m]

  private final BeamDirections directions = new BeamDirections();
  private double farthest; // farthest echo of this scanner so far [m]
  private double[] ends = {}; // end of each beam [m]; 0: no information
  private double[] free = {}; // free length of each beam [m]
  private double[] slants = {0.0}; // inverse distance of the line between adjacent ends
  private boolean[] echoes = {};
  private int beams;

  /** Begins a scan with this many beams. */
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

  /** Records a beam that hit an obstacle. */
  void echo(int beam, double range) {
    echoes[beam] = true;
    ends[beam] = range;
    farthest = Math.max(farthest, range);
  }

  /**
   * Records a beam that hit something other than an obstacle.
   *
   * @param measured measured range [m]
   * @param range maximum range over which it proves the absence of obstacles [m]
   */
  void harmless(int beam, double measured, double range) {
    farthest = Math.max(farthest, measured);
    noEcho(beam, range);
  }

  /**
   * Records a beam without an obstacle.
   *
   * @param range maximum range over which it proves this [m]; 0 for no information
   */
  void noEcho(int beam, double range) {
    echoes[beam] = false;
    ends[beam] = range;
  }

  /**
   * Ends a scan after all its beams.
   *
   * @param margin margin before an echo and before the line between two, for objects between beams
   *     [m]
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

  /** Inverse distance of the line from the previous beam's end; 0: not one surface. */
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
   * @param margin margin before an echo and before the line between two [m]
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

  /** Range at which a beam comes within the margin of a line, but at least the nearer end. */
  private static double before(double own, double other, double slant, double margin) {
    return Math.max(own - margin * own * slant, Math.min(own, other) - margin);
  }

  /**
   * Range up to which the space between a beam and the previous one is free [m]; ends where the
   * beams are a cell apart, because small objects fit between them beyond that range.
   */
  double between(int beam, double cell) {
    double both = Math.min(free[beam], free[beam - 1]);
    double apart = directions.apart(beam);
    return both * apart <= cell ? both : cell / apart;
  }
}
