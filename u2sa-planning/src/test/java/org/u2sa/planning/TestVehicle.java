package org.u2sa.planning;

import java.util.Optional;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A point mass that obeys navigation points at once: enough to see what a planner's points lead to.
 */
abstract class TestVehicle {
  /** Where north and east are counted from. */
  static final Geodetic ORIGIN = new Geodetic(8.0, 50.0, 0.0);

  double north;
  double east;
  double altitude;
  double heading;
  double speed;
  boolean onEarth = true;

  /** Moves on by a time step. */
  abstract void step(double dtS, Optional<NavigationPoint> point);

  /** Roll [rad], for vehicles that have it. */
  double bank() {
    return 0.0;
  }

  StateInformation state() {
    StateInformation state = new StateInformation().phi(bank()).theta(0.0).psi(heading);
    if (onEarth) {
      Geodetic place = ORIGIN.fromNed(Point.of(north, east, 0.0));
      return state
          .x(place.longitudeDeg())
          .y(place.latitudeDeg())
          .z(altitude)
          .xDot(speed * Math.sin(heading))
          .yDot(speed * Math.cos(heading));
    }
    return state
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east)
        .xDot(speed * Math.cos(heading))
        .yDot(speed * Math.sin(heading));
  }

  final void move(double dtS) {
    north += speed * Math.cos(heading) * dtS;
    east += speed * Math.sin(heading) * dtS;
    heading = Math.IEEEremainder(heading, 2.0 * Math.PI);
  }
}
