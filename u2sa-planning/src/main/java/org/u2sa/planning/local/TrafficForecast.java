package org.u2sa.planning.local;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.Mover;

/**
 * Predicts traffic from its velocity or trajectory, and its distance to the vehicle. A motion that
 * meets it is in its velocity obstacle (Fiorini, Shiller: Motion Planning in Dynamic Environments
 * Using Velocity Obstacles, International Journal of Robotics Research 17, 1998). Not thread-safe.
 */
final class TrafficForecast {
  static final double ROOMY_M = 2.0; // distance beyond which traffic is ignored

  private static final double GROWTH = 0.08; // uncertainty per distance travelled by traffic

  private final List<Mover> movers;
  private final BodyDiscs body;
  private final double keptM;
  private final Pose now;
  private final VerticalRoom room; // null: heights do not matter
  private final long nowMicros;

  TrafficForecast(
      List<Mover> movers,
      BodyDiscs body,
      MotionLimits limits,
      Pose now,
      long nowMicros,
      VerticalRoom room) {
    this.body = body;
    this.room = room;
    this.now = now;
    this.nowMicros = nowMicros;
    keptM = limits.trafficM();
    List<Mover> near = new ArrayList<>();
    for (Mover mover : movers) {
      if (mover.stepS() > 0.0 || mayComeNear(mover, limits)) {
        near.add(mover);
      }
    }
    this.movers = near;
  }

  /** Whether traffic moving straight on can meet the vehicle within the horizon. */
  private boolean mayComeNear(Mover mover, MotionLimits limits) {
    double age = mover.ageS(nowMicros);
    double away = now.distanceM(mover.northAfterM(age), mover.eastAfterM(age));
    double speed = Math.hypot(mover.northMps(), mover.eastMps()) * (1.0 + GROWTH);
    double near = mover.radiusM() + body.circleM() + keptM + ROOMY_M;
    return away < near + limits.horizonS() * (speed + limits.speedMps());
  }

  boolean isEmpty() {
    return movers.isEmpty();
  }

  /**
   * Gap between the vehicle at a pose and traffic at a time [m]; negative if they overlap.
   *
   * @param downM down coordinate of the vehicle then [m]
   */
  double gapM(Pose at, double downM, double seconds) {
    double gap = Double.POSITIVE_INFINITY;
    for (Mover mover : movers) {
      double age = mover.ageS(nowMicros);
      double north = mover.northAfterM(age + seconds);
      double east = mover.eastAfterM(age + seconds);
      double radius = mover.radiusM() + body.radiusM();
      double half = mover.heights().halfM() + body.radiusM();
      double up = upM(mover, downM, age + seconds, radius / half);
      for (int disc = 0; disc < body.count(); disc++) {
        double away = awayM(at, disc, north, east, up);
        gap = Math.min(gap, away - mover.radiusM() - body.radiusM());
      }
    }
    return gap;
  }

  /**
   * Whether traffic is too close at a time, and closer than it is now. The clearance is a cylinder
   * or, if heights matter, a spheroid.
   *
   * @param downM down coordinate of the vehicle then [m]
   */
  boolean meets(Pose at, double downM, double seconds) {
    for (Mover mover : movers) {
      double age = mover.ageS(nowMicros);
      double north = mover.northAfterM(age + seconds);
      double east = mover.eastAfterM(age + seconds);
      double grown = GROWTH * Math.hypot(mover.northMps(), mover.eastMps()) * seconds;
      double kept = mover.radiusM() + body.radiusM() + keptM + grown;
      double flat = flatness(mover, kept, seconds);
      double up = upM(mover, downM, age + seconds, flat);
      for (int disc = 0; disc < body.count(); disc++) {
        double away = awayM(at, disc, north, east, up);
        if (away < kept) {
          double upNow = room == null ? 0.0 : upM(mover, room.downM(), age, flat);
          double before = awayM(now, disc, mover.northAfterM(age), mover.eastAfterM(age), upNow);
          if (away < before - 0.02 * mover.radiusM()) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Ratio of the distances kept beside and above. */
  private double flatness(Mover mover, double keptBesideM, double seconds) {
    if (room == null) {
      return 0.0;
    }
    double grown = GROWTH * Math.abs(mover.heights().downMps()) * seconds;
    return keptBesideM / (mover.heights().halfM() + room.clearanceM() + grown);
  }

  /** Vertical distance, stretched by a ratio, which makes the spheroid a sphere [m]. */
  private double upM(Mover mover, double downM, double ageS, double ratio) {
    return room == null || ratio == 0.0 ? 0.0 : ratio * (mover.downAfterM(ageS) - downM);
  }

  private double awayM(Pose at, int disc, double north, double east, double up) {
    double along = body.aheadM(disc);
    double dn = at.northM() + along * Math.cos(at.headingRad()) - north;
    double de = at.eastM() + along * Math.sin(at.headingRad()) - east;
    return Math.sqrt(dn * dn + de * de + up * up);
  }
}
