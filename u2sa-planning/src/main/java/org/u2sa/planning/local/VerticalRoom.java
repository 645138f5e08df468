package org.u2sa.planning.local;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

/**
 * Room to climb and descend away from traffic. Altitudes are down coordinates on the planning plane
 * [m]. Immutable.
 *
 * @param downM altitude of the vehicle
 * @param goalDownM altitude of its goal, to which it climbs or descends unless it evades
 * @param rateMps rate at which it climbs and descends [m/s], above 0
 * @param clearanceM distance to keep above and below [m], above 0
 * @param groundM distance to keep from the ground in an evasion up or down [m]
 * @param levelM likewise in one to the altitude of the goal, which may be lower [m]
 * @param besideM distance to keep beside obstacles at other altitudes [m]
 * @param topDownM highest altitude allowed; −∞ without a limit
 * @param bottomDownM lowest altitude allowed; ∞ if unknown
 * @param elsewhere static obstacles at other altitudes than those between vehicle and goal
 * @param ground down coordinate of the ground at north and east; NaN if unknown
 * @param before direction of its last evasion: 1 up, −1 down, 0 none
 * @param lowest down coordinate at north and east, below which it does not descend to its goal; ∞
 *     where it descends at once
 */
public record VerticalRoom(
    double downM,
    double goalDownM,
    double rateMps,
    double clearanceM,
    double groundM,
    double levelM,
    double besideM,
    double topDownM,
    double bottomDownM,
    List<PlanarShape> elsewhere,
    DoubleBinaryOperator ground,
    int before,
    DoubleBinaryOperator lowest) {

  private static final double ROUNDING_M = 1.0e-6;

  /** Room of a vehicle that descends to its goal at once. */
  public VerticalRoom(
      double downM,
      double goalDownM,
      double rateMps,
      double clearanceM,
      double groundM,
      double levelM,
      double besideM,
      double topDownM,
      double bottomDownM,
      List<PlanarShape> elsewhere,
      DoubleBinaryOperator ground,
      int before) {
    this(
        downM,
        goalDownM,
        rateMps,
        clearanceM,
        groundM,
        levelM,
        besideM,
        topDownM,
        bottomDownM,
        elsewhere,
        ground,
        before,
        (north, east) -> Double.POSITIVE_INFINITY);
  }

  /** The same room without climbing. */
  public VerticalRoom withoutClimb() {
    return with(Math.max(topDownM, downM), lowest);
  }

  /** The same room with other lowest altitudes on the way to the goal. */
  public VerticalRoom descendingTo(DoubleBinaryOperator lowestM) {
    return with(topDownM, lowestM);
  }

  private VerticalRoom with(double highestDownM, DoubleBinaryOperator lowestM) {
    return new VerticalRoom(
        downM,
        goalDownM,
        rateMps,
        clearanceM,
        groundM,
        levelM,
        besideM,
        highestDownM,
        bottomDownM,
        elsewhere,
        ground,
        before,
        lowestM);
  }

  /** Altitudes for an evasion, in order of preference: the current one, then reachable ones. */
  double[] altitudes(double horizonS) {
    double change = rateMps * horizonS;
    double up = Math.min(downM, Math.max(topDownM, downM - change));
    double down = Math.max(downM, Math.min(bottomDownM, downM + change));
    return before < 0 ? new double[] {downM, down, up} : new double[] {downM, up, down};
  }

  /** Down coordinate after a time of climbing or descending to an altitude [m]. */
  double afterM(double toDownM, double seconds) {
    double change = rateMps * Math.max(0.0, seconds);
    return downM + Math.max(-change, Math.min(change, toDownM - downM));
  }

  /** Likewise on its way to the altitude of its goal, at a position. */
  double onWayM(Pose at, double seconds) {
    double lowestM = lowest.applyAsDouble(at.northM(), at.eastM());
    return Math.min(afterM(goalDownM, seconds), Math.max(downM, lowestM));
  }

  /** Whether known ground is too close to a vehicle that keeps to the altitude of its goal. */
  boolean isGroundNear(Pose at, double atDownM) {
    double groundDownM = ground.applyAsDouble(at.northM(), at.eastM());
    return atDownM + levelM > groundDownM + ROUNDING_M; // false where the ground is unknown
  }

  /** Whether the ground or an obstacle at another altitude is too close. */
  boolean isBlocked(Pose at, double atDownM) {
    double groundDownM = ground.applyAsDouble(at.northM(), at.eastM());
    boolean isUnknown = Double.isNaN(groundDownM) && bottomDownM == Double.POSITIVE_INFINITY;
    if (isUnknown ? atDownM > downM : atDownM + groundM > groundDownM + ROUNDING_M) {
      return true;
    }
    for (PlanarShape shape : elsewhere) {
      if (shape.reaches(atDownM, atDownM, clearanceM)
          && shape.distanceM(at.northM(), at.eastM()) < besideM) {
        return true;
      }
    }
    return false;
  }
}
