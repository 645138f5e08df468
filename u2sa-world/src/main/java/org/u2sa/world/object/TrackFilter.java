package org.u2sa.world.object;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.u2sa.messages.frame.Point;

/**
 * Estimates an object's position and motion with three parallel filters, for stationary,
 * constant-velocity and manoeuvring objects, weighted by how well each predicted the measurements
 * (multiple model estimation: Bar-Shalom, Li and Kirubarajan, 2001, section 11.6.2). Thus the
 * accuracy of stationary objects keeps improving, the velocity of a slow walker becomes observable,
 * and manoeuvres are followed, without knowledge of the kind of object.
 */
final class TrackFilter {
  /**
   * Motion assumptions about an object.
   *
   * @param maxSpeed standard deviation of an unknown velocity [m/s]; 0: always stationary
   * @param acceleration standard deviation of a moving object's acceleration, in speed or direction
   *     [m/s²]
   * @param systematic standard deviation of the error common to all sightings of a sensor, which
   *     does not average out [m]
   */
  record Assumptions(double maxSpeed, double acceleration, double systematic) {}

  private static final double MIN_CHANCE = 0.001; // so that an object may still start after hours
  private static final double AT_FIRST = 0.3;
  private static final double SURE = 0.9; // required to declare an object moving
  private static final double MOVING_SIGMAS = 2.0;
  private static final double SURELY_MPS = 0.1;

  private static final double STILL_SHARE = 0.7; // of the speed threshold, for hysteresis

  /** Acceleration of the constant-velocity model as a fraction of the assumed acceleration. */
  private static final double STEADY_SHARE = 0.1;

  /** Transition rate between constant velocity and manoeuvring [1/s]. */
  private static final double CHANGES_PER_S = 0.1;

  private final Assumptions assumed;
  private final MotionHypothesis standing;
  private final MotionHypothesis steady;
  private final MotionHypothesis turning;
  private final List<MotionHypothesis> all;
  private boolean moves; // as last seen
  private Point seenAt;

  TrackFilter(
      Point place,
      Point sigma,
      Optional<Point> velocity,
      OptionalDouble velocitySigma,
      Assumptions assumed) {
    this.assumed = assumed;
    double most = assumed.maxSpeed();
    boolean canMove = most > 0.0;
    double half = canMove ? 0.5 * AT_FIRST : 0.0;
    standing = new MotionHypothesis(place, sigma, 0.0, 0.0, 1.0 - 2.0 * half);
    steady = new MotionHypothesis(place, sigma, most, STEADY_SHARE * assumed.acceleration(), half);
    turning = new MotionHypothesis(place, sigma, most, assumed.acceleration(), half);
    all = canMove ? List.of(standing, steady, turning) : List.of(standing);
    seenAt = place;
    velocity.ifPresent(v -> see(v, velocitySigma.orElse(1.0)));
  }

  private void see(Point velocity, double sigma) {
    steady.goes(velocity, sigma);
    turning.goes(velocity, sigma);
    if (velocity.distance() > MOVING_SIGMAS * sigma) {
      believeMoving(1.0 - MIN_CHANCE);
      moves = isSurelyMoving();
    }
  }

  private void believeMoving(double chance) {
    standing.chance(1.0 - chance);
    steady.chance(0.5 * chance);
    turning.chance(0.5 * chance);
  }

  /** Predicts ahead in time [s, not negative]. */
  void predict(double seconds) {
    standing.predict(seconds);
    steady.predict(seconds);
    turning.predict(seconds);
    double change = 0.5 * (1.0 - Math.exp(-2.0 * CHANGES_PER_S * seconds));
    double gone = change * (steady.chance() - turning.chance());
    steady.chance(steady.chance() - gone);
    turning.chance(turning.chance() + gone);
  }

  /**
   * Resets the moving models of an object that was not seen for long: its predicted position would
   * spread without bound and match anything seen there.
   */
  void settle() {
    steady.restartAt(standing, assumed.maxSpeed());
    turning.restartAt(standing, assumed.maxSpeed());
    if (chance() > AT_FIRST) {
      believeMoving(AT_FIRST);
    }
    moves = false;
    seenAt = standing.place();
  }

  /** Squared Mahalanobis distance of a measurement from the best explaining model's prediction. */
  double distance(Point place, Point sigma) {
    double least = Double.POSITIVE_INFINITY;
    for (MotionHypothesis each : all) {
      least = Math.min(least, each.distance(place, sigma, squared(assumed.systematic())));
    }
    return least;
  }

  /**
   * Assignment cost, which also penalises uncertain predictions and unlikely models: −2 ln L up to
   * a constant (Bar-Shalom, Willett and Tian, Tracking and Data Fusion, 2011, section 7.2).
   * Otherwise, an object not seen for a while would match anything seen next.
   */
  double cost(Point place, Point sigma) {
    double least = Double.POSITIVE_INFINITY;
    for (MotionHypothesis each : all) {
      least = Math.min(least, each.cost(place, sigma, squared(assumed.systematic())));
    }
    return least;
  }

  void update(Point place, Point sigma, Optional<Point> velocity, OptionalDouble velocitySigma) {
    weigh(each -> each.likelihood(place, sigma));
    standing.update(place, sigma);
    steady.update(place, sigma);
    turning.update(place, sigma);
    velocity.ifPresent(v -> weigh(each -> each.speedLikelihood(v, velocitySigma)));
    steady.updateSpeed(velocity, velocitySigma);
    turning.updateSpeed(velocity, velocitySigma);
    if (turning.chance() > SURE * chance()) { // a steady course may start from here
      steady.adopt(turning);
    }
    if (chance() > SURE) { // a later stop is at the position of that time
      standing.restartAt(moving(), 0.0);
    }
    moves = isSurelyMoving();
    seenAt = believed().place();
  }

  /** Updates the model probabilities by Bayes' rule, with a lower bound. */
  private void weigh(ToDoubleFunction<MotionHypothesis> likelihood) {
    if (all.size() == 1) {
      return;
    }
    double best = Double.NEGATIVE_INFINITY;
    for (MotionHypothesis each : all) {
      best = Math.max(best, likelihood.applyAsDouble(each));
    }
    double sum = 0.0;
    for (MotionHypothesis each : all) {
      each.chance(each.chance() * Math.exp(likelihood.applyAsDouble(each) - best));
      sum += each.chance();
    }
    double floored = 0.0;
    for (MotionHypothesis each : all) {
      each.chance(Math.max(0.5 * MIN_CHANCE, each.chance() / sum));
      floored += each.chance();
    }
    for (MotionHypothesis each : all) {
      each.chance(each.chance() / floored);
    }
  }

  private double chance() {
    return steady.chance() + turning.chance();
  }

  /** Whether it is certain to move, with hysteresis to prevent flicker. */
  private boolean isSurelyMoving() {
    double least = Math.max(SURELY_MPS, velocitySigma());
    double speed = velocity().distance();
    return moves ? chance() > 0.5 && speed > STILL_SHARE * least : chance() > SURE && speed > least;
  }

  /** Whether it was moving when last seen. */
  boolean isMoving() {
    return moves;
  }

  /** Position [m]; an object not known to move stays where it was seen. */
  Point place() {
    return moves ? moving().place() : seenAt;
  }

  /** Standard deviations of {@link #place} [m]. */
  Point sigma() {
    return believed().sigma(squared(assumed.systematic()));
  }

  /** Velocity if it moves [m/s]. */
  Point velocity() {
    return moving().velocity();
  }

  /** Larger standard deviation of the horizontal velocity components [m/s]. */
  double velocitySigma() {
    return moving().velocitySigma();
  }

  private MotionHypothesis believed() {
    return chance() > 0.5 ? moving() : standing;
  }

  private MotionHypothesis moving() {
    return steady.chance() >= turning.chance() ? steady : turning;
  }

  private static double squared(double value) {
    return value * value;
  }
}
