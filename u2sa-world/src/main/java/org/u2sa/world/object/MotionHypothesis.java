package org.u2sa.world.object;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/** One assumption of how an object moves: a filter for each axis, and how likely it is. */
final class MotionHypothesis {
  private static final int AXES = 3;
  private static final double LEAST_VARIANCE = 1e-12; // [m²], of a measurement that claims no error

  private final AxisFilter[] axes = new AxisFilter[AXES];
  private final double noise;
  private double chance;

  /**
   * @param speedSigma of its unknown velocity [m/s]; 0: it stands
   * @param acceleration standard deviation of how it speeds up or turns [m/s²]
   * @param chance its probability at first
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

  /** Takes a velocity for granted, as the place is. */
  void goes(Point velocity, double sigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i] =
          new AxisFilter(
              axes[i].place(), axes[i].placeVariance(), axis(velocity, i), squared(sigma));
    }
  }

  /** Begins again where another is, with a velocity that is not known better than this [m/s]. */
  void restartAt(MotionHypothesis other, double speedSigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i] =
          new AxisFilter(
              other.axes[i].place(), other.axes[i].placeVariance(), 0.0, squared(speedSigma));
    }
  }

  /** Goes on as another does. */
  void adopt(MotionHypothesis other) {
    for (int i = 0; i < AXES; i++) {
      axes[i] = other.axes[i].copy();
    }
  }

  /** Moves on in time [s, not negative]; drift: by which the place is less certain then [m²]. */
  void predict(double seconds, double driftVariance) {
    for (int i = 0; i < AXES; i++) {
      axes[i].predict(seconds, noise);
      axes[i].drift(driftVariance);
    }
  }

  /** Takes a measurement. */
  void update(Point place, Point sigma) {
    for (int i = 0; i < AXES; i++) {
      axes[i].update(axis(place, i), Math.max(LEAST_VARIANCE, squared(axis(sigma, i))));
    }
  }

  /** Takes a measured velocity. */
  void updateSpeed(Optional<Point> velocity, OptionalDouble sigma) {
    for (int i = 0; i < AXES && velocity.isPresent(); i++) {
      axes[i].updateSpeed(axis(velocity.get(), i), squared(sigma.orElse(1.0)));
    }
  }

  /**
   * How far a measurement is from where the object is expected, squared, in standard deviations of
   * both (Mahalanobis).
   *
   * @param common variance of what all measurements have in common [m²]
   */
  double distance(Point place, Point sigma, double common) {
    double sum = 0.0;
    for (int i = 0; i < AXES; i++) {
      double total = axes[i].placeVariance() + squared(axis(sigma, i)) + common;
      sum += total == 0.0 ? 0.0 : squared(axis(place, i) - axes[i].place()) / total;
    }
    return sum;
  }

  /** The same, dearer the less sharply the place is foretold and the less likely this is. */
  double cost(Point place, Point sigma, double common) {
    double cost = distance(place, sigma, common) - 2.0 * Math.log(chance);
    for (int i = 0; i < AXES; i++) {
      double measured = Math.max(LEAST_VARIANCE, squared(axis(sigma, i)) + common);
      cost += Math.log(1.0 + axes[i].placeVariance() / measured);
    }
    return cost;
  }

  /** Logarithm of a measurement's likelihood, less a constant. */
  double likelihood(Point place, Point sigma) {
    double log = -0.5 * distance(place, sigma, 0.0);
    for (int i = 0; i < AXES; i++) {
      double total = axes[i].placeVariance() + squared(axis(sigma, i));
      log -= total == 0.0 ? 0.0 : 0.5 * Math.log(total);
    }
    return log;
  }

  /** Where it is [m]. */
  Point place() {
    return Point.of(axes[0].place(), axes[1].place(), axes[2].place());
  }

  /** Standard deviations of the place, with what all measurements have in common [m]. */
  Point sigma(double common) {
    return Point.of(
        Math.sqrt(common + Math.max(0.0, axes[0].placeVariance())),
        Math.sqrt(common + Math.max(0.0, axes[1].placeVariance())),
        Math.sqrt(common + Math.max(0.0, axes[2].placeVariance())));
  }

  /** [m/s]. */
  Point velocity() {
    return Point.of(axes[0].speed(), axes[1].speed(), axes[2].speed());
  }

  /** Largest standard deviation of the velocity along an axis of the plane [m/s]. */
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
