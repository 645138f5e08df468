package org.u2sa.sim.ground;

/** A free rolling front axle that steers: it gives way along, and creeps and slides across. */
final class SteeredWheel {
  /** Ahead of the centre of gravity [m]. */
  final double x;

  private double loadN;
  private final TyreParameters tyre;
  private double stiffness;
  private double gripN;
  private double dragN;

  // results of derive(), on the vehicle
  double forceForward;
  double forceRight;

  SteeredWheel(double x, double loadN, TyreParameters tyre) {
    this.x = x;
    this.tyre = tyre;
    load(loadN);
  }

  /** Takes what the axle carries from now on [N], above 0. */
  void load(double newtons) {
    loadN = newtons;
    stiffness = tyre.slipStiffness() * loadN / tyre.relaxationM();
  }

  void ground(double grip, double rolling) {
    gripN = grip * loadN;
    dragN = rolling * loadN;
  }

  /**
   * @param stretch of the tyre to the right [m]
   * @param steer right positive [rad]
   * @param forward velocity of the axle [m/s]
   * @param right velocity of the axle [m/s]
   * @return rate of change of the stretch [m/s]
   */
  double derive(double stretch, double steer, double forward, double right) {
    double sin = StrictMath.sin(steer);
    double cos = StrictMath.cos(steer);
    double rolling = forward * cos + right * sin;
    double drift = right * cos - forward * sin - Math.abs(rolling) / tyre.relaxationM() * stretch;
    double across = -stiffness * (stretch + tyre.dampingS() * drift);
    across = Math.max(-gripN, Math.min(gripN, across));
    double along = -dragN * PlanarVehicle.fading(rolling);
    forceForward = along * cos - across * sin;
    forceRight = along * sin + across * cos;
    return drift;
  }

  double bounded(double stretch) {
    double longest = gripN / stiffness;
    return Math.max(-longest, Math.min(longest, stretch));
  }
}
