package org.u2sa.planning;

import java.util.Optional;
import org.u2sa.messages.NavigationPoint;

/** A differential ground vehicle: at most 1 m/s and 1.5 rad/s, turns on the spot. */
final class TestRover extends TestVehicle {
  private static final double FULL_SPEED = 1.0;
  private static final double FULL_TURN = 1.5;

  TestRover(double north, double east, double heading) {
    this.north = north;
    this.east = east;
    this.heading = heading;
    onEarth = false;
  }

  @Override
  void step(double dtS, Optional<NavigationPoint> point) {
    speed = 0.0;
    if (point.isPresent()) {
      double off = -point.get().point().azimuth(); // BODY: y is to the left
      speed = FULL_SPEED * Math.max(0.0, Math.cos(off));
      heading += Math.max(-FULL_TURN, Math.min(FULL_TURN, 2.0 * off)) * dtS;
    }
    move(dtS);
  }
}
