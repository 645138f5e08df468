package org.u2sa.world.object;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/** One motion model of an object: a filter per axis and the model's probability. */
final class MotionHypothesis {
  private static final int AXES = 3;
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
          new AxisFilter(
              axes[i].place(), axes[i].placeVariance(), axis(velocity, i), squared(sigma));
    }
  }

  /** Restarts at another model's position with an unknown velocity of this sigma [m/s]. */
  void restartAt(MotionHypothesis other, double speedSigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i] =
          new AxisFilter(
              other.axes[i].place(), other.axes[i].placeVariance(), 0.0, squared(speedSigma));
    }
  }

  /** Copies another model's state. */
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

  /** Updates with a measured position. */
  void update(Point place, Point sigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i].update(axis(place, i), Math.max(MIN_VARIANCE, squared(axis(sigma, i))));
    }
  }

  /** Updates with a measured velocity. */
  void updateSpeed(Optional<Point> velocity, OptionalDouble sigma) {
    for (int i = 0; i < AXES && velocity.isPresent(); i++) {
      axes[i].updateSpeed(axis(velocity.get(), i), squared(sigma.orElse(1.0)));
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
      double total = axes[i].placeVariance() + squared(axis(sigma, i)) + common;
      sum += total == 0.0 ? 0.0 : squared(axis(place, i) - axes[i].place()) / total;
    }
    return sum;
  }

  /**
   * Assignment cost: the distance plus penalties for an uncertain prediction and an unlikely model.
   */
  double cost(Point place, Point sigma, double common) {
    double cost = distance(place, sigma, common) - 2.0 * Math.log(chance);
    for (int i = 0; i < AXES; i++) {
      double measured = Math.max(MIN_VARIANCE, squared(axis(sigma, i)) + common);
      cost += Math.log(1.0 + axes[i].placeVariance() / measured);
    }
    return cost;
  }

  /** Log-likelihood of a measurement, up to a constant. */
  double likelihood(Point place, Point sigma) {
    double log = -0.5 * distance(place, sigma, 0.0);
    for (int i = 0; i < AXES; i++) {
      double total = axes[i].placeVariance() + squared(axis(sigma, i));
      log -= total == 0.0 ? 0.0 : 0.5 * Math.log(total);
    }
    return log;
  }

  /** Position [m]. */
  Point place() {
    return Point.of(axes[0].place(), axes[1].place(), axes[2].place());
  }

  /** Standard deviations of the position, including the common error of all measurements [m]. */
  Point sigma(double common) {
    return Point.of(
        Math.sqrt(common + Math.max(0.0, axes[0].placeVariance())),
        Math.sqrt(common + Math.max(0.0, axes[1].placeVariance())),
        Math.sqrt(common + Math.max(0.0, axes[2].placeVariance())));
  }

  /** Velocity [m/s]. */
  Point velocity() {
    return Point.of(axes[0].speed(), axes[1].speed(), axes[2].speed());
  }

  /** Larger standard deviation of the horizontal velocity components [m/s]. */
  double velocitySigma() {
    return Math.sqrt(Math.max(0.0, Math.max(axes[0].speedVariance(), axes[1].speedVariance())));
  }

  private static double axis(Point point, int i) {
    return i == 0 ? point.x() : i == 1 ? point.y() : point.z();
  }

  private static double squared(double value) {
    return value * value;
  }
}
