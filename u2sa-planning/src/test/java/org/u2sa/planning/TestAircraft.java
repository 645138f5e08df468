package org.u2sa.planning;

import java.util.Optional;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/**
 * 46 m/s, 25° of bank at most, which it reaches in about a second; climbs and sinks at 3 m/s at
 * most.
 */
class TestAircraft extends TestVehicle {
  private static final double BANK_LIMIT = Math.toRadians(25.0);
  private static final double ROLL_TIME_S = 0.7;
  private double bank;

  TestAircraft(double north, double east, double altitude, double heading) {
    this.north = north;
    this.east = east;
    this.altitude = altitude;
    this.heading = heading;
    speed = 46.0;
  }

  @Override
  double bank() {
    return bank;
  }

  @Override
  void step(double dtS, Optional<NavigationPoint> point) {
    double wanted = 0.0;
    if (point.isPresent()) {
      Point body = point.get().point();
      double right =
          -body.y() * Math.cos(bank) - body.z() * Math.sin(bank); // undo the roll: FRD to level
      double down = -body.y() * Math.sin(bank) + body.z() * Math.cos(bank);
      double away = Math.hypot(body.x(), right);
      double off = Math.atan2(right, body.x());
      double limited = Math.max(-Math.PI / 2.0, Math.min(Math.PI / 2.0, off));
      wanted =
          Math.atan(2.0 * speed * speed / away * Math.sin(limited) / Gravity.STANDARD_MPS2); // L1
      wanted = Math.max(-BANK_LIMIT, Math.min(BANK_LIMIT, wanted));
      altitude += Math.max(-3.0, Math.min(3.0, -down / 3.0)) * dtS;
    }
    bank += (wanted - bank) * dtS / ROLL_TIME_S;
    heading += Gravity.STANDARD_MPS2 * Math.tan(bank) / speed * dtS;
    move(dtS);
  }
}
