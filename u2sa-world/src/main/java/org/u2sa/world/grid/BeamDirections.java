package org.u2sa.world.grid;

import java.util.List;
import org.u2sa.messages.RangeScan;

/** Directions of a scanner's beams and the angles between them, cached until they change. */
public final class BeamDirections {
  private double start = Double.NaN;
  private double step;
  private List<Double> angles = List.of();
  private double[] cos = {};
  private double[] sin = {};
  private double[] gapCos = {};
  private double[] gapSin = {};
  private double[] apart = {};

  /** Sets the directions from a scan with this many beams. */
  public void of(RangeScan scan, int beams) {
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
    cos = new double[beams];
    sin = new double[beams];
    gapCos = new double[beams];
    gapSin = new double[beams];
    apart = new double[beams];
    double before = 0.0;
    for (int i = 0; i < beams; i++) {
      double angle = angles.isEmpty() ? start + i * step : angles.get(i);
      cos[i] = Math.cos(angle);
      sin[i] = Math.sin(angle);
      gapCos[i] = Math.cos(angle - before);
      gapSin[i] = Math.abs(Math.sin(angle - before));
      apart[i] = 2.0 * Math.abs(Math.sin((angle - before) / 2.0));
      before = angle;
    }
  }

  public double cos(int beam) {
    return cos[beam];
  }

  public double sin(int beam) {
    return sin[beam];
  }

  /** Cosine of the angle between a beam and the previous one; undefined for the first beam. */
  double gapCos(int beam) {
    return gapCos[beam];
  }

  /** Absolute sine of that angle. */
  double gapSin(int beam) {
    return gapSin[beam];
  }

  /** Spacing of a beam from the previous beam, per metre of range. */
  double apart(int beam) {
    return apart[beam];
  }
}
