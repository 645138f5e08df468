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
  private final List<Moment> moments = new ArrayList<>(); // at the times of earlier calls
  private final double[] northM; // of the discs of the vehicle at the last pose
  private final double[] eastM;
  private final double[] northNowM; // likewise at its current pose
  private final double[] eastNowM;

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
    northM = new double[body.count()];
    eastM = new double[body.count()];
    northNowM = new double[body.count()];
    eastNowM = new double[body.count()];
    place(now, northNowM, eastNowM);
  }

  /** Traffic at a time: many motions are compared with it. */
  private final class Moment {
    private final double seconds;
    private final double[] north = new double[movers.size()];
    private final double[] east = new double[movers.size()];
    private final double[] down = new double[movers.size()];
    private final double[] kept = new double[movers.size()]; // distance beside them
    private final double[] flat = new double[movers.size()]; // its ratio to that above

    Moment(double seconds) {
      this.seconds = seconds;
      for (int i = 0; i < movers.size(); i++) {
        Mover mover = movers.get(i);
        double age = mover.ageS(nowMicros) + seconds;
        north[i] = mover.northAfterM(age);
        east[i] = mover.eastAfterM(age);
        down[i] = mover.downAfterM(age);
        double grown = GROWTH * Math.hypot(mover.northMps(), mover.eastMps()) * seconds;
        kept[i] = mover.radiusM() + body.radiusM() + keptM + grown;
        flat[i] = flatness(mover, kept[i], seconds);
      }
    }

    /** Vertical distance, stretched by a ratio, which makes the spheroid a sphere [m]. */
    private double upM(int mover, double downM, double ratio) {
      return room == null || ratio == 0.0 ? 0.0 : ratio * (down[mover] - downM);
    }

    private double awayM(int mover, double discNorthM, double discEastM, double up) {
      double dn = discNorthM - north[mover];
      double de = discEastM - east[mover];
      return Math.sqrt(dn * dn + de * de + up * up);
    }
  }

  private Moment moment(int tick, double seconds) {
    while (moments.size() <= tick) {
      moments.add(null);
    }
    Moment known = moments.get(tick);
    if (known == null || known.seconds != seconds) {
      known = new Moment(seconds);
      moments.set(tick, known);
    }
    return known;
  }

  private void place(Pose at, double[] norths, double[] easts) {
    double cos = Math.cos(at.headingRad());
    double sin = Math.sin(at.headingRad());
    for (int disc = 0; disc < norths.length; disc++) {
      double along = body.aheadM(disc);
      norths[disc] = at.northM() + along * cos;
      easts[disc] = at.eastM() + along * sin;
    }
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

  /** Places the vehicle for the following calls. */
  void place(Pose at) {
    place(at, northM, eastM);
  }

  /**
   * Gap between the vehicle and traffic at a time [m]; negative if they overlap.
   *
   * @param downM down coordinate of the vehicle then [m]
   * @param tick number of the time, among those of the compared motions
   */
  double gapM(double downM, int tick, double seconds) {
    Moment then = moment(tick, seconds);
    double gap = Double.POSITIVE_INFINITY;
    for (int i = 0; i < movers.size(); i++) {
      Mover mover = movers.get(i);
      double radius = mover.radiusM() + body.radiusM();
      double half = mover.heights().halfM() + body.radiusM();
      double up = then.upM(i, downM, radius / half);
      for (int disc = 0; disc < northM.length; disc++) {
        double away = then.awayM(i, northM[disc], eastM[disc], up);
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
   * @param tick number of the time, among those of the compared motions
   */
  boolean meets(double downM, int tick, double seconds) {
    Moment then = moment(tick, seconds);
    for (int i = 0; i < movers.size(); i++) {
      double up = then.upM(i, downM, then.flat[i]);
      for (int disc = 0; disc < northM.length; disc++) {
        double away = then.awayM(i, northM[disc], eastM[disc], up);
        if (away < then.kept[i] && away < beforeM(i, disc, then.flat[i])) {
          return true;
        }
      }
    }
    return false;
  }

  /** Current distance, less a little, of a disc of the vehicle to traffic [m]. */
  private double beforeM(int mover, int disc, double flat) {
    Moment start = moment(0, 0.0);
    double up = room == null ? 0.0 : start.upM(mover, room.downM(), flat);
    double away = start.awayM(mover, northNowM[disc], eastNowM[disc], up);
    return away - 0.02 * movers.get(mover).radiusM();
  }

  /** Ratio of the distances kept beside and above. */
  private double flatness(Mover mover, double keptBesideM, double seconds) {
    if (room == null) {
      return 0.0;
    }
    double grown = GROWTH * Math.abs(mover.heights().downMps()) * seconds;
    return keptBesideM / (mover.heights().halfM() + room.clearanceM() + grown);
  }
}
