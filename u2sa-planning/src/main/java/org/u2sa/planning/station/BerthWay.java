package org.u2sa.planning.station;

import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Station;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.Vehicle;

/** Target on the straight way to a berth, from its start to the berth. */
public final class BerthWay {
  /** Fraction of BERTH ACCURACY within which a vehicle that backed out is on the line again. */
  private static final double BACK_SHARE = 0.5;

  private final StationHeading heading;
  private boolean backsOut; // without sideways thrust, to get back on the line

  public BerthWay(StationHeading heading) {
    this.heading = heading;
  }

  /** Starts at the beginning of the way. */
  public void begin() {
    backsOut = false;
  }

  /**
   * A point ahead on the line. While the vehicle is off the line, the point is beside it, or, for a
   * vehicle without sideways thrust, behind it on the line.
   *
   * @param turnRad turn to the heading of the berth [rad], positive to the right
   */
  public NavigationPoint point(
      Leg leg,
      double downM,
      double turnRad,
      Station station,
      Vehicle vehicle,
      StationVariables settings) {
    double acrossM = Math.abs(leg.acrossM(0.0, 0.0));
    double alongM = leg.alongM(0.0, 0.0);
    boolean isOff = acrossM > settings.berthAccuracy();
    double speed = station.speed().orElse(settings.berthSpeed());
    heading.watch(acrossM, turnRad, settings.berthAccuracy(), vehicle.timestampMicros());
    if (!heading.facesTheWay()) {
      double ahead = alongM + (isOff ? 0.0 : settings.berthLookAhead());
      Point ned = on(leg, Math.min(leg.lengthM(), ahead), downM);
      return NavigationPoint.at(vehicle.body(ned))
          .speed(speed)
          .backwards(station.backwards())
          .turn(turnRad);
    }
    backsOut = isOff || backsOut && acrossM > BACK_SHARE * settings.berthAccuracy();
    double wayM = alongM + (backsOut ? -1.0 : 1.0) * settings.berthLookAhead();
    boolean isAstern = station.backwards() != backsOut;
    double astern = isAstern ? Math.PI : 0.0;
    return NavigationPoint.at(vehicle.body(on(leg, Math.min(leg.lengthM(), wayM), downM)))
        .speed(speed)
        .backwards(isAstern)
        .turn(Leg.wrapped(StationHeading.towardsRad(on(leg, wayM, downM), vehicle) + astern));
  }

  /** Whether the vehicle backed out beyond the start of the way without getting on its line. */
  public boolean hasLeft(Leg leg, StationVariables settings) {
    return backsOut
        && leg.alongM(0.0, 0.0) < 0.0
        && Math.abs(leg.acrossM(0.0, 0.0)) > settings.berthAccuracy();
  }

  private static Point on(Leg leg, double alongM, double downM) {
    return Point.of(leg.northAtM(alongM), leg.eastAtM(alongM), downM);
  }
}
