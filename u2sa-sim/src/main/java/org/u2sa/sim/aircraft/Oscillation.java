package org.u2sa.sim.aircraft;

import java.util.ArrayList;
import java.util.List;

/**
 * Period and damping of a decaying oscillation, read from its peaks as a flight-test engineer does.
 */
final class Oscillation {
  private static final int PEAKS_NEEDED = 4;

  private record Sample(double timeS, double value) {}

  private final List<Sample> peaks = new ArrayList<>();
  private Sample before;
  private Sample last;

  void add(double timeS, double value) {
    Sample sample = new Sample(timeS, value);
    if (before != null && (last.value - before.value) * (value - last.value) < 0.0) {
      peaks.add(last);
    }
    before = last;
    last = sample;
  }

  /** Of the first one and a half swings [s]; NaN if there were fewer. */
  double periodS() {
    return peaks.size() < PEAKS_NEEDED
        ? Double.NaN
        : 2.0 * (peaks.get(3).timeS - peaks.get(0).timeS) / 3.0;
  }

  /**
   * From the logarithmic decrement of peak-to-peak spans half a period apart; NaN if there were too
   * few.
   */
  double dampingRatio() {
    if (peaks.size() < PEAKS_NEEDED) {
      return Double.NaN;
    }
    double decrement = StrictMath.log(span(0) / span(2)) / 2.0;
    return decrement / StrictMath.hypot(Math.PI, decrement);
  }

  private double span(int index) {
    return Math.abs(peaks.get(index + 1).value - peaks.get(index).value);
  }
}
