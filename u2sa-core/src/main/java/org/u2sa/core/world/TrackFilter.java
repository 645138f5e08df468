package org.u2sa.core.world;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/**
 * Where an object is and how it moves, by two filters side by side: one takes it for standing, the
 * other for moving; how well each foretold the measurements decides which is believed (multiple
 * model estimation: Bar-Shalom, Li and Kirubarajan, 2001, section 11.6.2). So what stands is known
 * ever better, and what begins to move is followed, without anybody saying which is which.
 */
final class TrackFilter {
  /**
   * What is assumed of objects.
   *
   * @param maxSpeed standard deviation of an unknown velocity [m/s]; 0: everything stands
   * @param acceleration standard deviation of how a moving object speeds up or turns [m/s²]
   * @param drift standard deviation by which a standing object's place is less certain after a
   *     second [m]
   * @param systematic standard deviation of what all sightings of a sensor have in common, and no
   *     number of them averages out [m]
   */
  record Assumptions(double maxSpeed, double acceleration, double drift, double systematic) {}

  private static final int AXES = 3;
  private static final double LEAST_CHANCE = 0.001; // so that what stood for hours may still start
  private static final double AT_FIRST = 0.3;
  private static final double SURE = 0.9; // before something is said to move
  private static final double MOVING_SIGMAS = 2.0;
  private static final double SURELY_MPS = 0.1;

  private final Assumptions assumed;
  private final AxisFilter[] standing = new AxisFilter[AXES];
  private final AxisFilter[] moving = new AxisFilter[AXES];
  private double chance = AT_FIRST; // that it moves

  TrackFilter(
      Point place,
      Point sigma,
      Optional<Point> velocity,
      OptionalDouble velocitySigma,
      Assumptions assumed) {
    this.assumed = assumed;
    for (int i = 0; i < AXES; i++) {
      double variance = squared(axis(sigma, i));
      standing[i] = new AxisFilter(axis(place, i), variance, 0.0, 0.0);
      moving[i] = new AxisFilter(axis(place, i), variance, 0.0, squared(assumed.maxSpeed()));
    }
    velocity.ifPresent(v -> see(v, velocitySigma));
  }

  private void see(Point velocity, OptionalDouble velocitySigma) {
    double sigma = velocitySigma.orElse(1.0);
    for (int i = 0; i < AXES; i++) {
      moving[i] =
          new AxisFilter(
              moving[i].place(), moving[i].placeVariance(), axis(velocity, i), squared(sigma));
    }
    chance = velocity.distance() > MOVING_SIGMAS * sigma ? 1.0 - LEAST_CHANCE : chance;
  }

  /** Moves on in time [s, not negative]. */
  void predict(double seconds) {
    for (int i = 0; i < AXES; i++) {
      standing[i].predict(seconds, 0.0);
      if (assumed.drift() > 0.0) {
        AxisFilter axis = standing[i];
        standing[i] =
            new AxisFilter(
                axis.place(), axis.placeVariance() + squared(assumed.drift()) * seconds, 0.0, 0.0);
      }
      moving[i].predict(seconds, squared(assumed.acceleration()));
    }
  }

  /**
   * Gives up that it might move, for nobody has seen it for long: where it would be by now could be
   * anywhere, and it would be taken for whatever is seen there.
   */
  void settle() {
    for (int i = 0; i < AXES; i++) {
      moving[i] =
          new AxisFilter(
              standing[i].place(), standing[i].placeVariance(), 0.0, squared(assumed.maxSpeed()));
    }
    chance = Math.min(chance, AT_FIRST);
  }

  /**
   * How far a measurement is from where the object is expected, squared, in standard deviations of
   * both (Mahalanobis); by the filter that explains it better.
   */
  double distance(Point place, Point sigma) {
    double common = squared(assumed.systematic());
    double stands = distance(standing, place, sigma, common);
    return assumed.maxSpeed() == 0.0
        ? stands
        : Math.min(stands, distance(moving, place, sigma, common));
  }

  /**
   * The same, dearer the less sharply the object's place is foretold and the less the filter is
   * believed: minus twice the logarithm of the likelihood, less a constant (Bar-Shalom, Willett and
   * Tian, Tracking and Data Fusion, 2011, section 7.2). Else whatever has not been seen for a while
   * would be everything that is seen next.
   */
  double cost(Point place, Point sigma) {
    double stands = cost(standing, place, sigma) - 2.0 * Math.log(1.0 - chance);
    return assumed.maxSpeed() == 0.0
        ? stands
        : Math.min(stands, cost(moving, place, sigma) - 2.0 * Math.log(chance));
  }

  private double cost(AxisFilter[] filter, Point place, Point sigma) {
    double common = squared(assumed.systematic());
    double cost = distance(filter, place, sigma, common);
    for (int i = 0; i < AXES; i++) {
      double measured = Math.max(1e-12, squared(axis(sigma, i)) + common);
      cost += Math.log(1.0 + filter[i].placeVariance() / measured);
    }
    return cost;
  }

  private static double distance(AxisFilter[] filter, Point place, Point sigma, double variance) {
    double sum = 0.0;
    for (int i = 0; i < AXES; i++) {
      double total = filter[i].placeVariance() + squared(axis(sigma, i)) + variance;
      sum += total == 0.0 ? 0.0 : squared(axis(place, i) - filter[i].place()) / total;
    }
    return sum;
  }

  /** Logarithm of a measurement's likelihood, less a constant. */
  private static double likelihood(AxisFilter[] filter, Point place, Point sigma) {
    double log = -0.5 * distance(filter, place, sigma, 0.0);
    for (int i = 0; i < AXES; i++) {
      double total = filter[i].placeVariance() + squared(axis(sigma, i));
      log -= total == 0.0 ? 0.0 : 0.5 * Math.log(total);
    }
    return log;
  }

  /** Takes a measurement. */
  void update(Point place, Point sigma, Optional<Point> velocity, OptionalDouble velocitySigma) {
    if (assumed.maxSpeed() == 0.0) {
      chance = 0.0;
    } else {
      double ratio =
          Math.exp(
              Math.max(
                  -30.0,
                  Math.min(
                      30.0,
                      likelihood(moving, place, sigma) - likelihood(standing, place, sigma))));
      chance = chance * ratio / (chance * ratio + 1.0 - chance);
      chance = Math.max(LEAST_CHANCE, Math.min(1.0 - LEAST_CHANCE, chance));
    }
    for (int i = 0; i < AXES; i++) {
      double variance = Math.max(1e-12, squared(axis(sigma, i)));
      standing[i].update(axis(place, i), variance);
      moving[i].update(axis(place, i), variance);
      if (velocity.isPresent()) {
        moving[i].updateSpeed(axis(velocity.get(), i), squared(velocitySigma.orElse(1.0)));
      }
    }
    if (chance > SURE) { // a later stop is where it is then, not where it once stood
      for (int i = 0; i < AXES; i++) {
        standing[i] = new AxisFilter(moving[i].place(), moving[i].placeVariance(), 0.0, 0.0);
      }
    }
  }

  /** Whether it moves, as far as one can tell. */
  boolean isMoving() {
    return chance > SURE && velocity().distance() > Math.max(SURELY_MPS, velocitySigma());
  }

  /** Where it is [m]. */
  Point place() {
    AxisFilter[] believed = believed();
    return Point.of(believed[0].place(), believed[1].place(), believed[2].place());
  }

  /** Standard deviations of {@link #place} [m]. */
  Point sigma() {
    AxisFilter[] believed = believed();
    double common = squared(assumed.systematic());
    return Point.of(
        Math.sqrt(common + Math.max(0.0, believed[0].placeVariance())),
        Math.sqrt(common + Math.max(0.0, believed[1].placeVariance())),
        Math.sqrt(common + Math.max(0.0, believed[2].placeVariance())));
  }

  /** Its velocity, if it moves [m/s]. */
  Point velocity() {
    return Point.of(moving[0].speed(), moving[1].speed(), moving[2].speed());
  }

  /** Largest standard deviation of the velocity along an axis of the plane [m/s]. */
  double velocitySigma() {
    return Math.sqrt(Math.max(0.0, Math.max(moving[0].speedVariance(), moving[1].speedVariance())));
  }

  private AxisFilter[] believed() {
    return chance > 0.5 ? moving : standing;
  }

  private static double axis(Point point, int i) {
    return i == 0 ? point.x() : i == 1 ? point.y() : point.z();
  }

  private static double squared(double value) {
    return value * value;
  }
}
