package org.u2sa.planning.station;

import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * Decides which heading a vehicle keeps near a place at which it must have a certain one. A vehicle
 * with sideways thrust turns on its way there. One without comes no nearer with the place abeam: it
 * faces the place until it is there, then turns, and faces it again when it has been carried away.
 */
public final class StationHeading {
  /** Fraction of the tolerance within which the vehicle turns away from the place it faced. */
  private static final double THERE_SHARE = 0.5;

  /** Distance beyond which control faces a point that comes without a turn [m]. */
  private static final double FACED_M = 1.2;

  /** Time without progress after which the vehicle is assumed to lack sideways thrust. */
  private static final long STALLED_MICROS = 8 * Clock.MICROS_PER_SECOND;

  /** Fraction of the shortest distance by which a shorter one is progress. */
  private static final double PROGRESS_SHARE = 0.05;

  /** Reduction of the turn that is progress [rad]. */
  private static final double PROGRESS_RAD = Math.toRadians(5.0);

  private static final long NOT_YET = Long.MIN_VALUE;

  private boolean facesTheWay;
  private boolean isThere; // faced the place until close, and has not been carried away since
  private double shortestM;
  private double leastTurnRad;
  private long stalledSinceMicros = NOT_YET; // of the last progress

  /**
   * Begins a goal.
   *
   * @param lacksSway whether the vehicle is known to have no sideways thrust
   */
  public void begin(boolean lacksSway) {
    facesTheWay = lacksSway;
    isThere = false;
    stalledSinceMicros = NOT_YET;
  }

  /** Whether the vehicle must face a place to get there. */
  public boolean facesTheWay() {
    return facesTheWay;
  }

  /**
   * Turn to command [rad], positive to the right; empty if control is to face the place, at a speed
   * at which a rudder steers and against drift.
   *
   * @param ned way to the place: north, east [m]
   * @param turnRad turn to the heading required at the place
   * @param toleranceM distance within which the vehicle counts as being at the place
   */
  public OptionalDouble turnRad(Point ned, double turnRad, double toleranceM, Vehicle vehicle) {
    double distanceM = Math.hypot(ned.x(), ned.y());
    watch(distanceM, turnRad, toleranceM, vehicle.timestampMicros());
    isThere = distanceM <= (isThere ? toleranceM : THERE_SHARE * toleranceM);
    if (!facesTheWay || isThere) {
      return OptionalDouble.of(turnRad);
    }
    return distanceM > FACED_M
        ? OptionalDouble.empty()
        : OptionalDouble.of(towardsRad(ned, vehicle));
  }

  /** Turn to a place [rad], positive to the right. */
  public static double towardsRad(Point ned, Vehicle vehicle) {
    return Leg.wrapped(Math.atan2(ned.y(), ned.x()) - vehicle.headingRad());
  }

  /** Detects that the vehicle comes no nearer while it keeps, or turns to, the required heading. */
  public void watch(double distanceM, double turnRad, double toleranceM, long nowMicros) {
    if (distanceM <= toleranceM) {
      stalledSinceMicros = NOT_YET;
      return;
    }
    double turn = Math.abs(turnRad);
    boolean isFirst = stalledSinceMicros == NOT_YET;
    boolean isNearer = isFirst || distanceM < (1.0 - PROGRESS_SHARE) * shortestM;
    boolean isTurned = isFirst || turn < leastTurnRad - PROGRESS_RAD;
    shortestM = isNearer ? distanceM : shortestM;
    leastTurnRad = isTurned ? turn : leastTurnRad;
    if (isNearer || isTurned) {
      stalledSinceMicros = nowMicros;
    }
    facesTheWay |= nowMicros - stalledSinceMicros >= STALLED_MICROS;
  }

  public void handOver(HandOver state) {
    state.number("STATION FACES THE WAY", facesTheWay ? 1.0 : 0.0);
    state.number("STATION TURNED THERE", isThere ? 1.0 : 0.0);
  }

  public void takeOver(HandOver state) {
    begin(isSet(state.number("STATION FACES THE WAY")));
    isThere = isSet(state.number("STATION TURNED THERE"));
  }

  private static boolean isSet(OptionalDouble flag) {
    return flag.orElse(0.0) > 0.0;
  }
}
