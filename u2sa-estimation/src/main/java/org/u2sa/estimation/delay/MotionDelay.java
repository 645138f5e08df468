package org.u2sa.estimation.delay;

import org.u2sa.estimation.rotation.TurnedVectors;

/**
 * Shows how late a receiver's velocities are: for each of several delays, a filter predicts how
 * they change from the accelerations at the time of the measurement, and the likelihood of its
 * innovations tells how probable that delay is (a bank of filters, Magill 1965).
 *
 * <p>The forces have an error, so the difference between measured and gained velocity may wander;
 * the heading may be wrong, so the horizontal acceleration may be rotated. A circle therefore shows
 * no delay, but its beginning and end do. Evidence counts less as the best delay fits worse than
 * the noise claimed, so sensors that contradict each other show none. It is limited, so that a
 * delay that changes is found as soon as one that was there from the start.
 */
public final class MotionDelay {
  private static final double STEP_S = 0.05;
  private static final int DELAYS = 21;

  /** Longest delay that is found [s]. */
  public static final double MAX_S = (DELAYS - 1) * STEP_S;

  /** Evidence against a delay that makes it doubtful. */
  public static final double DOUBTED = 3.0;

  private static final int LAST = 0; // time of the newest velocity [s]
  private static final int COUNT = 1; // of velocities
  private static final int VARIANCE = 2; // of a vertical difference, for each delay the same
  private static final int SINCE = 3; // time since which the assumed delay is doubted [s]
  private static final int FIRST = 4; // number of the first delay
  private static final int TURNED = 0; // horizontal differences, of each delay
  private static final int DOWN = TURNED + TurnedVectors.SIZE; // vertical difference [m/s]
  private static final int GAINED = DOWN + 1; // path's velocity at the newest measurement: three
  private static final int EVIDENCE = GAINED + 3; // against this delay: log-likelihood ratio
  private static final int MISFIT = EVIDENCE + 1; // mean χ² per axis
  private static final int EACH = MISFIT + 1;

  /** Numbers of a receiver in the array. */
  public static final int SIZE = FIRST + DELAYS * EACH;

  private static final double WANDER = 0.15; // m/s per √s, error of the forces
  private static final double TURN_NOISE = 0.04; // rad per √s
  private static final double TURN_SIGMA = 2.0; // at first and at most
  private static final double MIN_SIGMA_MPS = 0.1;
  private static final double LONGEST_GAP_S = 1.5;
  private static final double MEMORY_S = 20.0;
  private static final double FIT_MEMORY = 20.0; // velocities
  private static final double MIN_MISFIT = 0.3;
  private static final double USUAL_S = 0.2;
  private static final double FEW = 8.0; // velocities
  private static final double MAX_MISFIT = 1.0; // otherwise no delay explains the velocities
  private static final double MUCH_BETTER = 0.5; // unless it does so by far
  private static final double MAX_EVIDENCE = 20.0; // evidence
  private static final double MAX_CHI2 = 25.0; // χ²

  private static final double CERTAIN = 10.0; // evidence

  private final double[] then = new double[6];
  private final double[] chi2 = new double[DELAYS];

  /**
   * Compares a velocity with the path.
   *
   * @param at index of the receiver's numbers
   * @param path see {@link InertialPath}
   * @param nowS time of the velocity as stated, which is that of the path [s]
   * @param v north, east, down [m/s]; down is NaN if not measured
   * @param sigma claimed [m/s]
   */
  public void velocity(double[] x, int at, double[] path, double nowS, double[] v, double sigma) {
    if (!InertialPath.then(path, MAX_S, then)) {
      x[at + COUNT] = 0.0;
      return;
    }
    double seconds = nowS - x[at + LAST];
    double white = Math.max(MIN_SIGMA_MPS, sigma) * Math.max(MIN_SIGMA_MPS, sigma);
    boolean isBegun = x[at + COUNT] > 0.0 && seconds < LONGEST_GAP_S;
    x[at + LAST] = nowS;
    x[at + COUNT] = isBegun ? x[at + COUNT] + 1.0 : 1.0;
    if (!isBegun) {
      begin(x, at, path, v, white);
      return;
    }
    double drift = WANDER * WANDER * seconds;
    x[at + VARIANCE] += drift;
    double total = x[at + VARIANCE] + white;
    for (int k = 0; k < DELAYS; k++) {
      int own = at + FIRST + k * EACH;
      InertialPath.then(path, k * STEP_S, then);
      double north = then[0] - x[own + GAINED];
      double east = then[1] - x[own + GAINED + 1];
      double down = then[2] - x[own + GAINED + 2];
      System.arraycopy(then, 0, x, own + GAINED, 3);
      TurnedVectors.wander(
          x, own + TURNED, drift, TURN_NOISE * TURN_NOISE * seconds, TURN_SIGMA * TURN_SIGMA);
      chi2[k] = TurnedVectors.update(x, own + TURNED, north, east, v[0], v[1], white);
      TurnedVectors.advance(x, own + TURNED, north, east);
      if (!Double.isNaN(v[2])) {
        x[own + DOWN] += down;
        double apart = v[2] - x[own + DOWN];
        x[own + DOWN] += apart * x[at + VARIANCE] / total;
        chi2[k] += apart * apart / total;
      }
    }
    x[at + VARIANCE] *= white / total;
    weigh(x, at, Double.isNaN(v[2]) ? 2.0 : 3.0, seconds);
  }

  private void begin(double[] x, int at, double[] path, double[] v, double white) {
    x[at + VARIANCE] = white;
    for (int k = 0; k < DELAYS; k++) {
      int own = at + FIRST + k * EACH;
      InertialPath.then(path, k * STEP_S, then);
      System.arraycopy(then, 0, x, own + GAINED, 3);
      TurnedVectors.begin(x, own + TURNED, v[0], v[1], white);
      TurnedVectors.known(x, own + TURNED, TURN_SIGMA * TURN_SIGMA);
      x[own + DOWN] = v[2];
    }
  }

  private void weigh(double[] x, int at, double rows, double seconds) {
    double misfit = Double.MAX_VALUE;
    double share = 1.0 / Math.min(FIT_MEMORY, x[at + COUNT]);
    for (int k = 0; k < DELAYS; k++) {
      int own = at + FIRST + k * EACH;
      x[own + MISFIT] += share * (chi2[k] / rows - x[own + MISFIT]);
      misfit = Math.min(misfit, x[own + MISFIT]);
    }
    double kept = Math.max(0.0, 1.0 - seconds / MEMORY_S);
    double best = Double.MAX_VALUE;
    for (int k = 0; k < DELAYS; k++) {
      int own = at + FIRST + k * EACH;
      double now = Math.min(MAX_CHI2, chi2[k] / Math.max(MIN_MISFIT, misfit)) / 2.0;
      x[own + EVIDENCE] = kept * x[own + EVIDENCE] + now;
      best = Math.min(best, x[own + EVIDENCE]);
    }
    for (int k = 0; k < DELAYS; k++) {
      int own = at + FIRST + k * EACH;
      x[own + EVIDENCE] = Math.min(MAX_EVIDENCE, x[own + EVIDENCE] - best);
    }
  }

  /** Of the velocities, and of what is usual. */
  private static double evidence(double[] x, int at, int k) {
    return x[at + FIRST + k * EACH + EVIDENCE] + k * STEP_S / USUAL_S;
  }

  private static int best(double[] x, int at) {
    int best = 0;
    for (int k = 1; k < DELAYS; k++) {
      best = evidence(x, at, k) < evidence(x, at, best) ? k : best;
    }
    return best;
  }

  private static double misfit(double[] x, int at, int k) {
    return x[at + FIRST + k * EACH + MISFIT];
  }

  /**
   * Evidence against a delay [s]: by how much the most probable one is more likely (log).
   *
   * @return 0 if there are too few velocities, or if no delay explains them
   */
  public static double against(double[] x, int at, double delayS) {
    double k = Math.min(DELAYS - 1.0, delayS / STEP_S);
    int low = (int) Math.min(DELAYS - 2.0, k);
    int best = best(x, at);
    double most = Math.max(MAX_MISFIT, MUCH_BETTER * misfit(x, at, (int) Math.rint(k)));
    if (x[at + COUNT] <= FEW || misfit(x, at, best) > most) {
      return 0.0;
    }
    double before = evidence(x, at, low);
    return before + (k - low) * (evidence(x, at, low + 1) - before) - evidence(x, at, best);
  }

  /**
   * Whether the velocities refute a delay, for longer than the one that they show: a fault of the
   * inertial sensors is not seen by a delayed path for so long, which therefore seems to be right.
   */
  public static boolean refutes(double[] x, int at, double delayS) {
    double against = against(x, at, delayS);
    if (against < DOUBTED) {
      x[at + SINCE] = x[at + LAST];
    }
    return against > CERTAIN && x[at + LAST] - x[at + SINCE] > meanS(x, at);
  }

  /** Mean of the delay [s]. */
  public static double meanS(double[] x, int at) {
    return moment(x, at, 0.0, 1);
  }

  /** Variance of the delay [s²]. */
  public static double variance(double[] x, int at) {
    return moment(x, at, meanS(x, at), 2);
  }

  private static double moment(double[] x, int at, double from, int power) {
    double sum = 0.0;
    double weights = 0.0;
    for (int k = 0; k < DELAYS; k++) {
      double weight = StrictMath.exp(-evidence(x, at, k));
      sum += weight * (power == 1 ? k * STEP_S - from : (k * STEP_S - from) * (k * STEP_S - from));
      weights += weight;
    }
    return sum / weights;
  }
}
