package org.u2sa.sim.ground;

/**
 * A free wheel that swivels behind its pivot. It rolls without sliding sideways, so its angle
 * follows from the pivot's motion; on the vehicle it acts with its rolling resistance alone.
 */
final class Castor {
  private final double x; // of the pivot, by the centre of gravity [m]
  private final double y;
  private final double trailM;
  private double loadN;
  private double dragN;

  // results of derive(), on the vehicle at the pivot
  double forceForward;
  double forceRight;

  Castor(double x, double y, double trailM, double loadN) {
    this.x = x;
    this.y = y;
    this.trailM = trailM;
    this.loadN = loadN;
  }

  /** Takes what the wheel carries from now on [N], above 0. */
  void load(double newtons) {
    loadN = newtons;
  }

  void ground(double rolling) {
    dragN = rolling * loadN;
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  /**
   * @param angle of the wheel's rolling direction, clockwise from the vehicle's [rad]
   * @return its rate of change [rad/s]
   */
  double derive(double angle, double u, double v, double yawRate) {
    double forward = u - yawRate * y; // of the pivot
    double right = v + yawRate * x;
    double sin = StrictMath.sin(angle);
    double cos = StrictMath.cos(angle);
    double drag = -dragN * PlanarVehicle.fading(forward * cos + right * sin);
    forceForward = drag * cos;
    forceRight = drag * sin;
    return (right * cos - forward * sin) / trailM - yawRate;
  }
}
