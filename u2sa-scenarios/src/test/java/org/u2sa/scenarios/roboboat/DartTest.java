package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.sim.vehicle.VehicleTruth;

class DartTest {
  private static final int SHOTS = 100;

  private static Hoop hoop() {
    Hoop hoop = new Hoop().radius(0.45).thickness(0.03).psi(-Math.PI / 2.0);
    hoop.uid("hoop").referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(4.5).z(1.0);
    return hoop;
  }

  /** Of 100 darts from the origin. */
  private static long hits(double headingDeg) {
    Attitude attitude = new Attitude(0.0, 0.0, Math.toRadians(headingDeg));
    VehicleTruth boat =
        new VehicleTruth(0.0, Point.ORIGIN, attitude, Point.ORIGIN, Point.ORIGIN, Point.ORIGIN);
    Random random = new Random(7L);
    return IntStream.range(0, SHOTS).filter(each -> Dart.shot(boat, random).passes(hoop())).count();
  }

  @Test
  void passes_bowAtTheHoop_mostDoEvenWithSpread() {
    assertThat(hits(0.0)).isGreaterThan(95);
  }

  @Test
  void passes_bow12DegreesOff_noneDoes() {
    assertThat(hits(12.0)).isZero();
  }

  @Test
  void passes_hoopBehindTheBoat_noneDoes() {
    assertThat(hits(180.0)).isZero();
  }
}
