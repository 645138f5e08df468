package org.u2sa.planning.rightofway;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.DoublePredicate;

/**
 * Chooses a course and speed among all encounters: the least alteration that is large enough to be
 * seen, to the side that the rules demand, and passes every vessel at the required distance. Alters
 * course rather than speed; if no choice is safe, takes the safest (rules 8 and 17(b)).
 */
final class CourseChoice {
  private static final double STEP_RAD = Math.toRadians(5.0);
  private static final double[] SPEEDS = {1.0, 0.5, 0.0}; // changes large enough to be seen
  private static final double ROOMIER = 1.25; // clearance of a new course, in required distances
  private static final double RIGHT_ANGLE_RAD = 0.5 * Math.PI;
  private static final double FREE = 1.25;
  private static final double KEPT = 1.0;
  private static final double NEAR =
      3.0; // multiple of the required distance beyond which the side of passing is free
  private static final double SLOWER = 1.0; // costs; an alteration by 90° costs 1
  private static final double TO_PORT = 0.1;
  private static final double OTHER_COURSE = 0.5;
  private static final double AGAINST_RULE = 6.0;
  private static final double UNSAFE = 10.0;

  private final OwnShip own;
  private final Collection<Encounter> encounters;
  private final List<Target> targets;
  private final RightOfWayVariables settings;
  private final DoublePredicate isOpen;

  /**
   * @param targets all vessels around, with or without an encounter
   * @param isOpen whether static obstacles leave a course [rad] free
   */
  CourseChoice(
      OwnShip own,
      Collection<Encounter> encounters,
      List<Target> targets,
      RightOfWayVariables settings,
      DoublePredicate isOpen) {
    this.own = own;
    this.encounters = encounters;
    this.targets = targets;
    this.settings = settings;
    this.isOpen = isOpen;
  }

  /** Distance at which to pass a target [m], including its uncertainty after a time. */
  double requiredM(Target target, double afterS) {
    double kept = settings.passingDistance();
    return kept
        + target.radiusM()
        + own.limits().radiusM()
        + Math.min(0.5 * kept, target.sigmaAfterM(afterS));
  }

  /** Passing distance as a fraction of the required one, within the horizon. */
  double share(Target target, Approach approach, double horizonS) {
    double time = Math.max(0.0, Math.min(horizonS, approach.closestS()));
    return approach.distanceM(time) / requiredM(target, time);
  }

  private double horizonS() {
    return 1.5 * settings.giveWayTime();
  }

  /** Smallest {@link #share} of all targets. */
  private double leastShare(double courseRad, double speedMps, double horizonS) {
    double least = Double.POSITIVE_INFINITY;
    for (Target target : targets) {
      Approach approach = own.approach(target, courseRad, speedMps);
      boolean opens = approach.closestS() <= 0.0; // already diverging, whatever its distance
      double share = share(target, approach, horizonS);
      least = Math.min(least, opens ? Math.max(1.0, share) : share);
    }
    return least;
  }

  /** Whether a course passes astern of vessels where required, and port to port. */
  boolean passesByRule(double courseRad, double speedMps) {
    for (Encounter each : encounters) {
      Target target = each.target();
      Approach approach = own.approach(target, courseRad, speedMps);
      double nearM = NEAR * requiredM(target, 0.0);
      boolean ahead =
          each.rule() == Rule.CROSSING_GIVE_WAY
              && approach.crossesAheadM(target, horizonS()) < nearM;
      boolean starboard =
          each.rule() == Rule.HEAD_ON
              && approach.closestS() > 0.0
              && approach.distanceM(approach.closestS()) < nearM
              && approach.passesToStarboard(courseRad);
      if (ahead || starboard) {
        return false;
      }
    }
    return true;
  }

  /** Whether an alteration goes to the side that all rules demand. */
  private boolean isToTheRightSide(double changeRad) {
    for (Encounter each : encounters) {
      boolean anySide = each.rule() == Rule.OVERTAKING || each.rule() == Rule.OVERTAKEN;
      if (each.mustAct() && !anySide && changeRad < 0.0) {
        return false;
      }
    }
    return true;
  }

  /** Whether a manoeuvre may continue: it is still safe and passes vessels on the right side. */
  boolean isKept(CourseOrder now) {
    double speed = now.speedShare() * own.speedMps();
    return leastShare(now.courseRad(), speed, horizonS()) >= KEPT
        && isOpen.test(now.courseRad())
        && passesByRule(now.courseRad(), speed);
  }

  /** Whether the vehicle may take up its own course. */
  boolean isFree(double courseRad) {
    return leastShare(courseRad, own.speedMps(), settings.riskHorizon()) >= FREE
        && passesByRule(courseRad, own.speedMps());
  }

  /**
   * Chooses a course and speed.
   *
   * @param now current manoeuvre, from which the result should differ little
   * @param reason reason given in the result
   */
  CourseOrder choose(Optional<CourseOrder> now, String reason) {
    double from = now.map(CourseOrder::fromRad).orElse(own.courseRad());
    double least = Double.POSITIVE_INFINITY;
    CourseOrder best = null;
    int count = (int) Math.round(Math.PI / STEP_RAD);
    for (int k = -count + 1; k <= count; k++) {
      double change = k * STEP_RAD;
      boolean seen = Math.abs(change) >= Math.toRadians(settings.minAlteration()) - 1.0e-9;
      for (double share : SPEEDS) {
        boolean possible = share == 1.0 || share * own.speedMps() >= own.limits().slowestMps();
        if (possible && (seen || k == 0 && share < 1.0)) {
          double cost = cost(from + change, change, share, now);
          if (cost < least) {
            least = cost;
            best = new CourseOrder(from + change, share, from, reason);
          }
        }
      }
    }
    return best;
  }

  private double cost(double courseRad, double changeRad, double share, Optional<CourseOrder> now) {
    double speed = share * own.speedMps();
    double safety = leastShare(courseRad, speed, horizonS());
    double cost = square(changeRad / RIGHT_ANGLE_RAD) + (changeRad < 0.0 ? TO_PORT : 0.0);
    cost += share < 1.0 ? SLOWER + 1.0 - share : 0.0;
    if (now.isPresent()) {
      cost +=
          OTHER_COURSE
              * square(Angles.wrapped(courseRad - now.get().courseRad()) / RIGHT_ANGLE_RAD);
    }
    if (!isToTheRightSide(changeRad) || !passesByRule(courseRad, speed)) {
      cost += AGAINST_RULE;
    }
    if (safety < ROOMIER) {
      cost += UNSAFE * (safety < 1.0 ? 2.0 - safety : 0.2 * (ROOMIER - safety));
    }
    return isOpen.test(courseRad) ? cost : cost + UNSAFE;
  }

  private static double square(double value) {
    return value * value;
  }
}
