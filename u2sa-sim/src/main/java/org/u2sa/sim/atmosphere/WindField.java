package org.u2sa.sim.atmosphere;

/**
 * Air velocity at one aircraft, advanced step by step: the steady part and gusts of a {@link Wind}.
 */
public final class WindField {
  private final Wind wind;
  private final DrydenGusts gusts;
  private double northMps;
  private double eastMps;
  private double downMps;

  /**
   * @param spanM wing span of the aircraft [m]
   */
  public WindField(Wind wind, double spanM) {
    this.wind = wind;
    this.gusts = new DrydenGusts(wind.gustSigmaMps(), spanM, wind.seed());
  }

  /**
   * Advances by one step.
   *
   * @param heightM aircraft's height above ground [m]
   * @param airspeedMps its true airspeed [m/s]
   * @param cosHeading cosine of its true heading, along which the longitudinal gusts lie
   * @param sinHeading sine of its true heading
   */
  public void step(
      double dtS, double heightM, double airspeedMps, double cosHeading, double sinHeading) {
    gusts.step(dtS, heightM, airspeedMps);
    double steady = wind.speedMps() * wind.profile().share(heightM);
    double forward = gusts.forwardMps();
    double right = gusts.rightMps();
    northMps = -steady * StrictMath.cos(wind.fromRad()) + cosHeading * forward - sinHeading * right;
    eastMps = -steady * StrictMath.sin(wind.fromRad()) + sinHeading * forward + cosHeading * right;
    downMps = gusts.downMps();
  }

  /** Air velocity, north component [m/s]. */
  public double northMps() {
    return northMps;
  }

  /** Air velocity, east component [m/s]. */
  public double eastMps() {
    return eastMps;
  }

  /** Air velocity, down component [m/s]. */
  public double downMps() {
    return downMps;
  }

  /** The gusts alone, including angular rates. */
  public DrydenGusts gusts() {
    return gusts;
  }
}
