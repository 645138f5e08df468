package org.u2sa.sim.performance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Chooses the actuators that accelerate a vehicle most along one axis. Accelerations along other
 * axes are cancelled, the most important first, unless that would cost more than two thirds of the
 * effect.
 */
public final class PureMotion {
  private static final double COST_OF_OTHERS = 10_000.0; // leaves about a ten-thousandth of them
  private static final double KEPT = 1.0 / 3.0;
  private static final int SWEEPS = 50_000;
  private static final double CONVERGED = 1e-9; // change of all shares in a sweep
  private static final double ROUNDING = 0.005; // share of an actuator
  private static final double ROUNDING_ERROR = 1e-9; // of the strongest axis

  private final double[][][] effects;

  /**
   * @param effects acceleration by actuator, its full command (0: positive, 1: negative) and axis
   */
  public PureMotion(double[][][] effects) {
    double[] all = new double[effects[0][0].length];
    for (double[][] each : effects) {
      Arrays.setAll(all, k -> all[k] + Math.max(Math.abs(each[0][k]), Math.abs(each[1][k])));
    }
    double most = Arrays.stream(all).max().orElseThrow();
    this.effects = new double[effects.length][2][all.length];
    for (int i = 0; i < effects.length; i++) {
      for (int side = 0; side < 2; side++) {
        double[] each = effects[i][side];
        Arrays.setAll(
            this.effects[i][side], k -> all[k] > ROUNDING_ERROR * most ? each[k] / all[k] : 0.0);
      }
    }
  }

  /**
   * Shares of each actuator's full effect, negative for that of its negative command.
   *
   * @param sign direction along the axis, 1 or −1
   * @param others axes along which the vehicle should not accelerate, in order of importance
   */
  public double[] along(int axis, double sign, List<Integer> others) {
    double[] best = most(axis, sign, List.of());
    double least = KEPT * sign * sum(best, effects)[axis];
    List<Integer> cancelled = new ArrayList<>();
    for (int other : others) {
      cancelled.add(other);
      double[] shares = most(axis, sign, cancelled);
      if (sign * sum(shares, effects)[axis] >= least) {
        best = shares;
      } else {
        cancelled.remove(cancelled.size() - 1);
      }
    }
    return Arrays.stream(best).map(PureMotion::rounded).toArray();
  }

  private static double rounded(double share) {
    double whole = Math.rint(share);
    return Math.abs(share - whole) < ROUNDING ? whole + 0.0 : share; // no −0
  }

  /** Maximises the acceleration along the axis less the cost of others, actuator by actuator. */
  private double[] most(int axis, double sign, List<Integer> cancelled) {
    double[] shares = new double[effects.length];
    double[] sums = new double[effects[0][0].length];
    double change = Double.POSITIVE_INFINITY;
    for (int sweep = 0; sweep < SWEEPS && change > CONVERGED; sweep++) {
      change = 0.0;
      for (int i = 0; i < shares.length; i++) {
        double before = shares[i];
        add(sums, effects[i], before, -1.0);
        shares[i] = 0.0;
        double most = 0.0;
        for (int side = 0; side < 2; side++) {
          double slope = sign * effects[i][side][axis];
          double curvature = 0.0;
          for (int k : cancelled) {
            double effect = effects[i][side][k];
            slope -= COST_OF_OTHERS * sums[k] * effect;
            curvature += COST_OF_OTHERS * effect * effect;
          }
          double share = slope > 0.0 ? Math.min(1.0, slope / curvature) : 0.0;
          double gain = slope * share - 0.5 * curvature * share * share;
          if (gain > most) {
            most = gain;
            shares[i] = side == 0 ? share : -share;
          }
        }
        add(sums, effects[i], shares[i], 1.0);
        change += Math.abs(shares[i] - before);
      }
    }
    return shares;
  }

  /** Acceleration along each axis with shares of the actuators' effects. */
  public static double[] sum(double[] shares, double[][][] effects) {
    double[] sums = new double[effects[0][0].length];
    for (int i = 0; i < shares.length; i++) {
      add(sums, effects[i], shares[i], 1.0);
    }
    return sums;
  }

  private static void add(double[] sums, double[][] effect, double share, double sign) {
    for (int k = 0; k < sums.length; k++) {
      sums[k] += sign * Math.abs(share) * effect[share > 0.0 ? 0 : 1][k];
    }
  }
}
