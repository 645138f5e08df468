package org.u2sa.core.world;

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
  private double[] along = {};
  private boolean[] echoes = {};
  private int beams;

  /** Begins a scan with so many beams. */
  void begin(RangeScan scan, int count) {
    directions.of(scan, count);
    beams = count;
    if (count > ends.length) {
      ends = new double[count];
      free = new double[count];
      along = new double[count];
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
   * @param beamMargin the same for the beam itself [m]
   */
  void cut(double margin, double beamMargin) {
    for (int i = 0; i < beams; i++) {
      if (!echoes[i]) {
        boolean dropped = i > 0 && i + 1 < beams && echoes[i - 1] && echoes[i + 1];
        double seen = dropped ? Math.max(ends[i - 1], ends[i + 1]) : farthest;
        ends[i] = Math.min(ends[i], seen);
      }
    }
    for (int i = 0; i < beams; i++) {
      free[i] = echoes[i] ? Math.max(0.0, ends[i] - margin) : ends[i];
      along[i] = echoes[i] ? Math.max(0.0, ends[i] - beamMargin) : ends[i];
      if (i > 0 && (echoes[i] || echoes[i - 1])) {
        cutPair(i, margin, beamMargin);
      }
    }
  }

  /** Cuts a beam and the one before where they are a margin from the line between their ends. */
  private void cutPair(int beam, double margin, double beamMargin) {
    double one = ends[beam - 1];
    double two = ends[beam];
    double cos = directions.gapCos(beam);
    if (one == 0.0 || two == 0.0 || cos <= 0.0) {
      return; // says nothing, or too far apart to be of one surface
    }
    double line = Math.sqrt(Math.max(0.0, one * one + two * two - 2.0 * one * two * cos));
    double slant = line / Math.max(TINY, directions.gapSin(beam)); // law of sines
    double nearer = Math.min(one, two);
    cut(beam - 1, slant / two, nearer, margin, beamMargin);
    cut(beam, slant / one, nearer, margin, beamMargin);
  }

  private void cut(int beam, double slant, double nearer, double margin, double beamMargin) {
    double end = ends[beam];
    double beside = Math.max(end - margin * slant, Math.max(0.0, nearer - margin));
    double itself = Math.max(end - beamMargin * slant, Math.max(0.0, nearer - beamMargin));
    free[beam] = Math.min(free[beam], beside);
    along[beam] = Math.min(along[beam], itself);
  }

  /** Free length of a beam itself [m]. */
  double along(int beam) {
    return along[beam];
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
