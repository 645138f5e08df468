package org.u2sa.sim.motion;

/** Equations of motion: how fast each number of a state vector changes. */
public interface Motion {
  /**
   * Gives the rates of change at a state.
   *
   * @param state not changed
   * @param rate filled, of the same length; per second
   */
  void derivatives(double[] state, double[] rate);
}
