package org.u2sa.world.object;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/** One motion model of an object: a filter per axis and the model's probability. */
final class MotionHypothesis {
  private static final int AXES = 3;
  private static final double DEFAULT_SPEED_SIGMA = 1.0; // [m/s]
  private static final double MIN_VARIANCE = 1e-12; // [m²], for measurements that claim zero error

  private final AxisFilter[] axes = new AxisFilter[AXES];
  private final double noise;
  private double chance;

  /**
   * @param speedSigma standard deviation of the unknown velocity [m/s]; 0: stationary
   * @param acceleration standard deviation of the acceleration, in speed or direction [m/s²]
   * @param chance initial probability
   */
  MotionHypothesis(
      Point place, Point sigma, double speedSigma, double acceleration, double chance) {
    noise = squared(acceleration);
    this.chance = chance;
    for (int i = 0; i < AXES; i++) {
      axes[i] = new AxisFilter(axis(place, i), squared(axis(sigma, i)), 0.0, squared(speedSigma));
    }
  }

  double chance() {
    return chance;
  }

  void chance(double probability) {
    chance = probability;
  }

  /** Sets the velocity and keeps the position. */
  void goes(Point velocity, double sigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i] =
          new AxisFilter(axes[i].place, axes[i].placeVariance, axis(velocity, i), squared(sigma));
    }
  }

  /** Restarts at another model's position with an unknown velocity of this sigma [m/s]. */
  void restartAt(MotionHypothesis other, double speedSigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i] =
          new AxisFilter(
              other.axes[i].place, other.axes[i].placeVariance, 0.0, squared(speedSigma));
    }
  }

  void adopt(MotionHypothesis other) {
    for (int i = 0; i < AXES; i++) {
      axes[i] = other.axes[i].copy();
    }
  }

  /** Predicts ahead in time [s, not negative]. */
  void predict(double seconds) {
    for (int i = 0; i < AXES; i++) {
      axes[i].predict(seconds, noise);
    }
  }

  void update(Point place, Point sigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i].update(axis(place, i), Math.max(MIN_VARIANCE, squared(axis(sigma, i))));
    }
  }

  void updateSpeed(Optional<Point> velocity, OptionalDouble sigma) {
    for (int i = 0; i < AXES && velocity.isPresent(); i++) {
      axes[i].updateSpeed(axis(velocity.get(), i), squared(sigma.orElse(DEFAULT_SPEED_SIGMA)));
    }
  }

  /**
   * Squared Mahalanobis distance of a measurement from the predicted position.
   *
   * @param common variance of the error common to all measurements [m²]
   */
  double distance(Point place, Point sigma, double common) {
    double sum = 0.0;
    for (int i = 0; i < AXES; i++) {
      double total = axes[i].placeVariance + squared(axis(sigma, i)) + common;
      sum += total == 0.0 ? 0.0 : squared(axis(place, i) - axes[i].place) / total;
    }
    return sum;
  }

  /** Assignment cost: distance plus penalties for uncertain predictions and unlikely models. */
  double cost(Point place, Point sigma, double common) {
    double cost = distance(place, sigma, common) - 2.0 * Math.log(chance);
    for (int i = 0; i < AXES; i++) {
      double measured = Math.max(MIN_VARIANCE, squared(axis(sigma, i)) + common);
      cost += Math.log(1.0 + axes[i].placeVariance / measured);
    }
    return cost;
  }

  /** Log-likelihood of a measurement, up to a constant. */
  double likelihood(Point place, Point sigma) {
    double log = -0.5 * distance(place, sigma, 0.0);
    for (int i = 0; i < AXES; i++) {
      double total = axes[i].placeVariance + squared(axis(sigma, i));
      log -= total == 0.0 ? 0.0 : 0.5 * Math.log(total);
    }
    return log;
  }

  /** Log-likelihood of a measured velocity [m/s], up to a constant. */
  double speedLikelihood(Point velocity, OptionalDouble sigma) {
    double log = 0.0;
    for (int i = 0; i < AXES; i++) {
      double total = axes[i].speedVariance + squared(sigma.orElse(DEFAULT_SPEED_SIGMA));
      log -= 0.5 * (squared(axis(velocity, i) - axes[i].speed) / total + Math.log(total));
    }
    return log;
  }

  /** Position [m]. */
  Point place() {
    return Point.of(axes[0].place, axes[1].place, axes[2].place);
  }

  /** Standard deviations of the position, including the common error of all measurements [m]. */
  Point sigma(double common) {
    return Point.of(
        Math.sqrt(common + Math.max(0.0, axes[0].placeVariance)),
        Math.sqrt(common + Math.max(0.0, axes[1].placeVariance)),
        Math.sqrt(common + Math.max(0.0, axes[2].placeVariance)));
  }

  /** Velocity [m/s]. */
  Point velocity() {
    return Point.of(axes[0].speed, axes[1].speed, axes[2].speed);
  }

  /** Larger standard deviation of the horizontal velocity components [m/s]. */
  double velocitySigma() {
    return Math.sqrt(Math.max(0.0, Math.max(axes[0].speedVariance, axes[1].speedVariance)));
  }

  private static double axis(Point point, int i) {
    return i == 0 ? point.x() : i == 1 ? point.y() : point.z();
  }

  private static double squared(double value) {
    return value * value;
  }

  /**
   * A Kalman filter of position and velocity along one axis, driven by white acceleration
   * (Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and Navigation, 2001,
   * section 6.2.2).
   */
  static final class AxisFilter {
    private double place; // position [m]
    private double speed; // velocity [m/s]
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
  }
}
