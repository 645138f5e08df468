package org.u2sa.world.object;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/**
 * Where an object is and how it moves, by three filters side by side: one takes it for standing,
 * one for moving on steadily, one for moving as it likes; how well each foretold the measurements
 * decides which is believed (multiple model estimation: Bar-Shalom, Li and Kirubarajan, 2001,
 * section 11.6.2). So what stands is known ever better, a slow walker's velocity is known at all,
 * and what turns or speeds up is followed, without anybody saying which is which.
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

  private static final double LEAST_CHANCE = 0.001; // so that what stood for hours may still start
  private static final double AT_FIRST = 0.3;
  private static final double SURE = 0.9; // before something is said to move
  private static final double MOVING_SIGMAS = 2.0;
  private static final double SURELY_MPS = 0.1;

  private static final double STILL_SHARE = 0.7; // of the least speed of what sets off

  /** What moves on steadily does so much less of what is assumed of a moving object. */
  private static final double STEADY_SHARE = 0.1;

  /** How often what moves changes between going steadily and not [1/s]. */
  private static final double CHANGES_PER_S = 0.1;

  private final Assumptions assumed;
  private final MotionHypothesis standing;
  private final MotionHypothesis steady;
  private final MotionHypothesis turning;
  private final List<MotionHypothesis> all;
  private boolean moves; // as it was seen last
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
      believeMoving(1.0 - LEAST_CHANCE);
      moves = isSurelyMoving();
    }
  }

  private void believeMoving(double chance) {
    standing.chance(1.0 - chance);
    steady.chance(0.5 * chance);
    turning.chance(0.5 * chance);
  }

  /** Moves on in time [s, not negative]. */
  void predict(double seconds) {
    standing.predict(seconds, squared(assumed.drift()) * seconds);
    steady.predict(seconds, 0.0);
    turning.predict(seconds, 0.0);
    double change = 0.5 * (1.0 - Math.exp(-2.0 * CHANGES_PER_S * seconds));
    double gone = change * (steady.chance() - turning.chance());
    steady.chance(steady.chance() - gone);
    turning.chance(turning.chance() + gone);
  }

  /**
   * Gives up that it might move, for nobody has seen it for long: where it would be by now could be
   * anywhere, and it would be taken for whatever is seen there.
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

  /**
   * How far a measurement is from where the object is expected, squared, in standard deviations of
   * both (Mahalanobis); by the filter that explains it best.
   */
  double distance(Point place, Point sigma) {
    double least = Double.POSITIVE_INFINITY;
    for (MotionHypothesis each : all) {
      least = Math.min(least, each.distance(place, sigma, squared(assumed.systematic())));
    }
    return least;
  }

  /**
   * The same, dearer the less sharply the object's place is foretold and the less the filter is
   * believed: minus twice the logarithm of the likelihood, less a constant (Bar-Shalom, Willett and
   * Tian, Tracking and Data Fusion, 2011, section 7.2). Else whatever has not been seen for a while
   * would be everything that is seen next.
   */
  double cost(Point place, Point sigma) {
    double least = Double.POSITIVE_INFINITY;
    for (MotionHypothesis each : all) {
      least = Math.min(least, each.cost(place, sigma, squared(assumed.systematic())));
    }
    return least;
  }

  /** Takes a measurement. */
  void update(Point place, Point sigma, Optional<Point> velocity, OptionalDouble velocitySigma) {
    weigh(place, sigma);
    standing.update(place, sigma);
    steady.update(place, sigma);
    turning.update(place, sigma);
    steady.updateSpeed(velocity, velocitySigma);
    turning.updateSpeed(velocity, velocitySigma);
    if (turning.chance() > SURE * chance()) { // goes on steadily from now on, perhaps
      steady.adopt(turning);
    }
    if (chance() > SURE) { // a later stop is where it is then, not where it once stood
      standing.restartAt(moving(), 0.0);
    }
    moves = isSurelyMoving();
    seenAt = believed().place();
  }

  /** Each is believed as it foretold this (Bayes), but none ever not at all. */
  private void weigh(Point place, Point sigma) {
    if (all.size() == 1) {
      return;
    }
    double best = Double.NEGATIVE_INFINITY;
    for (MotionHypothesis each : all) {
      best = Math.max(best, each.likelihood(place, sigma));
    }
    double sum = 0.0;
    for (MotionHypothesis each : all) {
      each.chance(each.chance() * Math.exp(each.likelihood(place, sigma) - best));
      sum += each.chance();
    }
    double floored = 0.0;
    for (MotionHypothesis each : all) {
      each.chance(Math.max(0.5 * LEAST_CHANCE, each.chance() / sum));
      floored += each.chance();
    }
    for (MotionHypothesis each : all) {
      each.chance(each.chance() / floored);
    }
  }

  /** That it moves. */
  private double chance() {
    return steady.chance() + turning.chance();
  }

  /** What is known to move is believed to for longer, so that it does not come and go. */
  private boolean isSurelyMoving() {
    double least = Math.max(SURELY_MPS, velocitySigma());
    double speed = velocity().distance();
    return moves ? chance() > 0.5 && speed > STILL_SHARE * least : chance() > SURE && speed > least;
  }

  /** Whether it moved when it was seen last, as far as one can tell. */
  boolean isMoving() {
    return moves;
  }

  /** Where it is [m]; what is not known to move stays where it was seen. */
  Point place() {
    return moves ? moving().place() : seenAt;
  }

  /** Standard deviations of {@link #place} [m]. */
  Point sigma() {
    return believed().sigma(squared(assumed.systematic()));
  }

  /** Its velocity, if it moves [m/s]. */
  Point velocity() {
    return moving().velocity();
  }

  /** Largest standard deviation of the velocity along an axis of the plane [m/s]. */
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
