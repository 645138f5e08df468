package org.u2sa.world.object;

/**
 * A Kalman filter of position and velocity along one axis, driven by white acceleration
 * (Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and Navigation, 2001,
 * section 6.2.2).
 */
final class AxisFilter {
  private double place;
  private double speed;
  private double placeVariance;
  private double covariance;
  private double speedVariance;

  AxisFilter(double place, double placeVariance, double speed, double speedVariance) {
    this.place = place;
    this.placeVariance = placeVariance;
    this.speed = speed;
    this.speedVariance = speedVariance;
  }

  /**
   * Predicts ahead in time.
   *
   * @param seconds not negative
   * @param noise spectral density of the acceleration [m²/s³]
   */
  void predict(double seconds, double noise) {
    place += seconds * speed;
    placeVariance +=
        seconds * (2.0 * covariance + seconds * speedVariance)
            + noise * seconds * seconds * seconds / 3.0;
    covariance += seconds * speedVariance + noise * seconds * seconds / 2.0;
    speedVariance += noise * seconds;
  }

  /** Returns a copy. */
  AxisFilter copy() {
    AxisFilter copy = new AxisFilter(place, placeVariance, speed, speedVariance);
    copy.covariance = covariance;
    return copy;
  }

  /** Updates with a measured position [m] and its variance [m²]. */
  void update(double measured, double variance) {
    double innovation = measured - place;
    double total = placeVariance + variance;
    double gain = placeVariance / total;
    double speedGain = covariance / total;
    place += gain * innovation;
    speed += speedGain * innovation;
    speedVariance -= speedGain * covariance;
    covariance *= 1.0 - gain;
    placeVariance *= 1.0 - gain;
  }

  /** Updates with a measured speed [m/s] and its variance. */
  void updateSpeed(double measured, double variance) {
    double innovation = measured - speed;
    double total = speedVariance + variance;
    double gain = speedVariance / total;
    double placeGain = covariance / total;
    speed += gain * innovation;
    place += placeGain * innovation;
    placeVariance -= placeGain * covariance;
    covariance *= 1.0 - gain;
    speedVariance *= 1.0 - gain;
  }

  /** Position [m]. */
  double place() {
    return place;
  }

  /** Velocity [m/s]. */
  double speed() {
    return speed;
  }

  /** Position variance [m²]. */
  double placeVariance() {
    return placeVariance;
  }

  /** Velocity variance [m²/s²]. */
  double speedVariance() {
    return speedVariance;
  }
}
