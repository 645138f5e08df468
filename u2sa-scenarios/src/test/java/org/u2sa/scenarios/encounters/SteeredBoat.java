package org.u2sa.scenarios.encounters;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.u2sa.planning.rightofway.CourseOrder;
import org.u2sa.planning.rightofway.OwnShip;
import org.u2sa.planning.rightofway.RightOfWay;
import org.u2sa.planning.rightofway.RightOfWayVariables;
import org.u2sa.planning.rightofway.Target;

/**
 * A point that turns and accelerates at limited rates, steered through a case by right of way
 * alone: hundreds of cases in seconds.
 */
final class SteeredBoat {
  private static final double STEP_S = 0.25;
  private static final double TURN_RAD_PER_S = Math.toRadians(12.0);
  private static final double MPS2 = 0.3;
  private static final double RUN_ON_S = 60.0;
  private static final double LONGEST_S = 900.0;
  private static final double CORRELATION_S = 5.0; // of errors of tracks
  private static final RightOfWayVariables SETTINGS =
      new RightOfWayVariables(RightOfWayVariables.Rules.COLREGS, 20.0, 300.0, 120.0, 60.0, 35.0);

  private final EncounterCase encounter;
  private final double sigmaM;
  private final double sigmaMps;
  private final Random random;
  private final double[][] errors;
  private final RightOfWay rules;
  private final List<String> said = new ArrayList<>();
  private double northM;
  private double eastM;
  private double courseRad;
  private double speedMps = EncounterCase.OWN_MPS;
  private int manoeuvres;

  /**
   * @param sigmaM standard deviation of tracks' positions [m]; of their velocities 3 % of that per
   *     second
   */
  SteeredBoat(EncounterCase encounter, double sigmaM, long seed) {
    this.encounter = encounter;
    this.sigmaM = sigmaM;
    sigmaMps = 0.03 * sigmaM;
    random = new Random(seed);
    errors = new double[encounter.vessels().size()][4];
    rules = new RightOfWay(() -> SETTINGS, said::add);
  }

  /** Number of manoeuvres after {@link #run}, changes included. */
  int manoeuvres() {
    return manoeuvres;
  }

  EncounterScore run() {
    EncounterScore score = new EncounterScore(encounter);
    double goalM = EncounterCase.OWN_MPS * (encounter.lastClosestS() + RUN_ON_S);
    Optional<CourseOrder> before = Optional.empty();
    for (double now = 0.0; now < LONGEST_S && northM < goalM; now += STEP_S) {
      score.see(now, northM, eastM, courseRad, speedMps);
      double wanted = Math.atan2(-eastM, goalM - northM);
      Optional<CourseOrder> decided = rules.decide(own(wanted), targets(now), course -> true, now);
      score.hear(rules.remark());
      Optional<CourseOrder> last = before;
      boolean isOther =
          decided.filter(next -> last.isEmpty() || isOther(next, last.get())).isPresent();
      manoeuvres += isOther ? 1 : 0;
      before = decided;
      steer(
          decided.map(CourseOrder::courseRad).orElse(wanted),
          EncounterCase.OWN_MPS * decided.map(CourseOrder::speedShare).orElse(1.0));
    }
    return score;
  }

  private static boolean isOther(CourseOrder next, CourseOrder last) {
    return next.courseRad() != last.courseRad() || next.speedShare() != last.speedShare();
  }

  private OwnShip own(double wantedRad) {
    return new OwnShip(
        northM,
        eastM,
        speedMps * Math.cos(courseRad),
        speedMps * Math.sin(courseRad),
        wantedRad,
        EncounterCase.OWN_MPS,
        new OwnShip.Limits(1.0, TURN_RAD_PER_S, MPS2, 0.3, 0.0));
  }

  private List<Target> targets(double nowS) {
    double kept = Math.exp(-STEP_S / CORRELATION_S);
    List<Target> targets = new ArrayList<>();
    for (int i = 0; i < errors.length; i++) {
      double[] error = errors[i];
      for (int k = 0; k < error.length; k++) {
        error[k] = kept * error[k] + Math.sqrt(1.0 - kept * kept) * random.nextGaussian();
      }
      EncounterCase.Vessel vessel = encounter.vessels().get(i);
      targets.add(
          new Target(
              vessel.uid(),
              vessel.northAtM(nowS) + sigmaM * error[0],
              vessel.eastAtM(nowS) + sigmaM * error[1],
              vessel.northMps() + sigmaMps * error[2],
              vessel.eastMps() + sigmaMps * error[3],
              2.1,
              sigmaM,
              sigmaMps));
    }
    return targets;
  }

  private void steer(double wantedRad, double wantedMps) {
    double turn = Math.IEEEremainder(wantedRad - courseRad, 2.0 * Math.PI);
    courseRad += limited(turn, TURN_RAD_PER_S * STEP_S);
    speedMps += limited(wantedMps - speedMps, MPS2 * STEP_S);
    northM += STEP_S * speedMps * Math.cos(courseRad);
    eastM += STEP_S * speedMps * Math.sin(courseRad);
  }

  private static double limited(double value, double most) {
    return Math.max(-most, Math.min(most, value));
  }
}
