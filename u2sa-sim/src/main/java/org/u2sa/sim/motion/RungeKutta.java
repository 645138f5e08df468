package org.u2sa.sim.motion;

/** Classical fourth-order Runge–Kutta integrator with reusable buffers. Not thread-safe. */
public final class RungeKutta {
  private final double[] k1;
  private final double[] k2;
  private final double[] k3;
  private final double[] k4;
  private final double[] between;

  /**
   * @param size length of the state vectors
   */
  public RungeKutta(int size) {
    k1 = new double[size];
    k2 = new double[size];
    k3 = new double[size];
    k4 = new double[size];
    between = new double[size];
  }

  /**
   * Advances a state by one step.
   *
   * @param state read and replaced
   * @param dtS step size [s]
   */
  public void step(Motion motion, double[] state, double dtS) {
    step(motion, state, dtS, 1);
  }

  /**
   * Advances a state in equal steps.
   *
   * @param dtS time of all steps [s]
   */
  public void step(Motion motion, double[] state, double dtS, int steps) {
    for (int i = 0; i < steps; i++) {
      single(motion, state, dtS / steps);
    }
  }

  private void single(Motion motion, double[] state, double dtS) {
    motion.derivatives(state, k1);
    advance(state, k1, dtS / 2);
    motion.derivatives(between, k2);
    advance(state, k2, dtS / 2);
    motion.derivatives(between, k3);
    advance(state, k3, dtS);
    motion.derivatives(between, k4);
    for (int i = 0; i < state.length; i++) {
      state[i] += dtS / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
  }

  private void advance(double[] state, double[] slope, double dtS) {
    for (int i = 0; i < state.length; i++) {
      between[i] = state[i] + dtS * slope[i];
    }
  }

  /** Equations of motion: derivative of a state vector. */
  public interface Motion {
    /**
     * Computes the derivative at a state.
     *
     * @param state input, not modified
     * @param rate output of the same length, per second
     */
    void derivatives(double[] state, double[] rate);
  }
}
