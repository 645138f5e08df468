package org.u2sa.planning.local;

/**
 * Speed of a vehicle on a surface that has to stop after a distance. It decelerates less than it
 * could, so that control can correct what it lags behind. Immutable.
 */
public final class StopSpeed {
  private static final double SHARE = 0.7; // of the deceleration
  private static final double CREEPS_MPS = 0.15; // slowest speed on the way to a place

  private final MotionLimits limits;

  public StopSpeed(MotionLimits limits) {
    this.limits = limits;
  }

  /**
   * Distance beyond which nothing slows the vehicle down [m].
   *
   * @param nowMps its present speed
   */
  public double reachM(double nowMps) {
    return limits.stoppingM(Math.max(limits.speedMps(), nowMps)) / SHARE;
  }

  /**
   * Speed to command [m/s]; never so low that the vehicle does not get there.
   *
   * @param wayM distance after which it stops; infinite if it need not
   * @param nowMps its present speed that way; as much as it is too fast, the command is lower,
   *     because the vehicle follows it late
   */
  public double mps(double wayM, double nowMps) {
    double most = stoppableMps(wayM);
    double command = most < limits.speedMps() ? most - Math.max(0.0, nowMps - most) : most;
    return Math.min(limits.speedMps(), Math.max(CREEPS_MPS, command));
  }

  private double stoppableMps(double wayM) {
    double braking = SHARE * limits.brakingMps2();
    double b = braking * limits.reactionS(); // v²/2b + v t = left
    return Math.min(limits.speedMps(), Math.sqrt(b * b + 2.0 * braking * Math.max(0.0, wayM)) - b);
  }
}
