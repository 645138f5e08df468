package org.u2sa.core.world;

import java.util.List;
import org.u2sa.messages.RangeScan;

/**
 * The directions of a scanner's beams and of the borders between them, kept from scan to scan as
 * they rarely change. Each beam stands for the sector half-way to its neighbours, but for no more
 * than {@link #WIDEST} to each side.
 */
final class BeamDirections {
  /** Half of the widest sector that a single beam says anything of [rad]. */
  static final double WIDEST = Math.toRadians(1.0);

  private double start = Double.NaN;
  private double step;
  private List<Double> angles = List.of();
  private double[] cos = {};
  private double[] sin = {};
  private double[] leftCos = {};
  private double[] leftSin = {};
  private double[] rightCos = {};
  private double[] rightSin = {};
  private boolean[] apart = {};

  /** Takes the directions of a scan with so many beams. */
  void of(RangeScan scan, int beams) {
    boolean same =
        beams == cos.length
            && (scan.angles().isEmpty()
                ? angles.isEmpty() && scan.startAngle() == start && scan.angleIncrement() == step
                : scan.angles().equals(angles));
    if (same) {
      return;
    }
    start = scan.startAngle();
    step = scan.angleIncrement();
    angles = scan.angles();
    double[] all = new double[beams];
    for (int i = 0; i < beams; i++) {
      all[i] = angles.isEmpty() ? start + i * step : angles.get(i);
    }
    cos = new double[beams];
    sin = new double[beams];
    leftCos = new double[beams];
    leftSin = new double[beams];
    rightCos = new double[beams];
    rightSin = new double[beams];
    apart = new boolean[beams];
    for (int i = 0; i < beams; i++) {
      cos[i] = Math.cos(all[i]);
      sin[i] = Math.sin(all[i]);
      double before = all[i] - half(all, i, i - 1);
      apart[i] = i > 0 && Math.abs(all[i] - all[i - 1]) > 2.0 * WIDEST;
      double after = all[i] + half(all, i + 1, i);
      leftCos[i] = Math.cos(before);
      leftSin[i] = Math.sin(before);
      rightCos[i] = Math.cos(after);
      rightSin[i] = Math.sin(after);
    }
  }

  /** Half of the way between two beams that follow each other, with its sign. */
  private static double half(double[] all, int later, int earlier) {
    double way =
        earlier >= 0 && later < all.length
            ? all[later] - all[earlier]
            : all.length > 1 ? all[1] - all[0] : 2.0 * WIDEST;
    return Math.max(-WIDEST, Math.min(WIDEST, Math.IEEEremainder(way, 2.0 * Math.PI) / 2.0));
  }

  double cos(int beam) {
    return cos[beam];
  }

  double sin(int beam) {
    return sin[beam];
  }

  /** Whether there is a gap of which nothing is known between a beam and the one before. */
  boolean isApart(int beam) {
    return apart[beam];
  }

  /** Direction of the border to the beam before. */
  double beforeCos(int beam) {
    return leftCos[beam];
  }

  double beforeSin(int beam) {
    return leftSin[beam];
  }

  /** Direction of the border to the beam after. */
  double afterCos(int beam) {
    return rightCos[beam];
  }

  double afterSin(int beam) {
    return rightSin[beam];
  }
}
