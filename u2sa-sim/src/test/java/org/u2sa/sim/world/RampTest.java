package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** 15 % up to 0.45 m, a top of 1 m, and down again; to the north, 4 m wide. */
class RampTest {
  private static final Ramp RAMP =
      new Ramp(
          List.of(
              Point.of(0.0, 0.0, 0.0),
              Point.of(0.0, 3.0, 0.45),
              Point.of(0.0, 4.0, 0.45),
              Point.of(0.0, 7.0, 0.0)),
          4.0);
  private static final World LAWN =
      World.at(new Geodetic(11.0, 48.0, 500.0)).with((Terrain) new RampedGround(List.of(RAMP)));

  private static double seenM(double north, double up, double elevationRad) {
    return LAWN.distanceM(Ray.of(Point.of(0.3, north, up), 0.0, elevationRad), 20.0);
  }

  @Test
  void distanceM_levelLaserLowerThanTheTop_isAWallBehindTheFoot() {
    assertThat(seenM(-3.0, 0.4, 0.0)).isCloseTo(3.0 + 0.4 / 0.15, within(1.0e-9));
  }

  @Test
  void distanceM_levelLaserHigherThanTheTop_passesOver() {
    assertThat(seenM(-3.0, 0.46, 0.0)).isInfinite();
  }

  @Test
  void distanceM_laserThatTiltsDownTheRamp_meetsTheLawnBehindIt() {
    double tilt = -Math.atan(0.15);
    double height = 0.45 - 0.15 * 2.0 + 0.4; // 2 m down the way down
    assertThat(seenM(6.0, height, tilt))
        .isCloseTo(height / Math.sin(Math.atan(0.15)), within(1.0e-9));
  }

  @Test
  void distanceM_fromTheSide_isTheUprightSide() {
    Ray west = Ray.of(Point.of(5.0, 3.5, 0.2), -0.5 * Math.PI, 0.0);
    assertThat(LAWN.distanceM(west, 20.0)).isCloseTo(3.0, within(1.0e-9));
    Ray over = Ray.of(Point.of(5.0, 3.5, 0.5), -0.5 * Math.PI, 0.0);
    assertThat(LAWN.distanceM(over, 20.0)).isInfinite();
  }

  /** A march by the profile, which knows nothing of planes. */
  @Test
  void distanceM_raysAtRandom_areThoseOfAMarch() {
    Random random = new Random(5L);
    for (int i = 0; i < 300; i++) {
      Point from = Point.of(6.0 * random.nextDouble() - 3.0, 12.0 * random.nextDouble() - 3.0, 0.6);
      Ray ray =
          Ray.of(from, 2.0 * Math.PI * random.nextDouble(), -0.05 - 0.4 * random.nextDouble());
      double marched = 0.0;
      while (marched < 15.0 && !isInside(ray.at(marched))) {
        marched += 1.0e-3;
      }
      double seen = LAWN.distanceM(ray, 15.0);
      assertThat(Math.min(15.0, seen)).as("%s", ray).isCloseTo(marched, within(0.05));
    }
  }

  private static boolean isInside(Point at) {
    boolean isOver = Math.abs(at.x()) <= 2.0 && at.y() >= 0.0 && at.y() <= 7.0;
    double up = Math.min(0.45, 0.15 * Math.min(at.y(), 7.0 - at.y()));
    return at.z() < (isOver ? up : 0.0);
  }

  @ParameterizedTest
  @CsvSource({"-1.0, 0.0", "0.0, 0.075", "1.5, 0.15", "3.5, 0.0", "4.0, -0.075", "5.0, -0.15"})
  void riseNorth_alongIt_isThatBetweenTheWheels(double north, double rise) {
    assertThat(LAWN.terrain().riseNorth(0.5, north)).isCloseTo(rise, within(1.0e-9));
    assertThat(LAWN.terrain().riseEast(0.5, north)).isCloseTo(0.0, within(1.0e-9));
    double step = 1.0e-5;
    double gained =
        LAWN.terrain().heightM(0.5, north + step) - LAWN.terrain().heightM(0.5, north - step);
    assertThat(gained / 2.0 / step).isCloseTo(rise, within(1.0e-4));
  }

  @Test
  void heightM_onTheWayUpAndBeside_isThatOfTheBoardsAndNone() {
    assertThat(LAWN.terrain().heightM(0.0, 2.0)).isCloseTo(0.3, within(1.0e-9));
    assertThat(LAWN.terrain().heightM(2.1, 2.0)).isZero();
    assertThat(LAWN.terrain().heightM(0.0, 8.0)).isZero();
  }

  @Test
  void ramp_thatDips_isRefused() {
    assertThatThrownBy(
            () ->
                new Ramp(
                    List.of(
                        Point.of(0.0, 0.0, 0.0),
                        Point.of(0.0, 2.0, 0.1),
                        Point.of(0.0, 3.0, 0.4),
                        Point.of(0.0, 6.0, 0.0)),
                    3.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("ramp is not convex");
  }

  @Test
  void ramp_thatBendsOrFloats_isRefused() {
    assertThatThrownBy(
            () ->
                new Ramp(
                    List.of(
                        Point.of(0.0, 0.0, 0.0), Point.of(0.5, 2.0, 0.1), Point.of(0.0, 4.0, 0.0)),
                    3.0))
        .hasMessageContaining("ramp is not straight");
    assertThatThrownBy(
            () ->
                new Ramp(
                    List.of(
                        Point.of(0.0, 0.0, 0.2), Point.of(0.0, 2.0, 0.3), Point.of(0.0, 4.0, 0.0)),
                    3.0))
        .hasMessageContaining("foot above the ground");
  }

  /** Rays from all around, against steps of a millimetre along each. */
  @Test
  void meets_rayFromOutside_isWhereItFirstComesUnderTheSurface() {
    Random random = new Random(5L);
    int met = 0;
    for (int i = 0; i < 400; i++) {
      double x = 12.0 * random.nextDouble() - 6.0;
      double y = 16.0 * random.nextDouble() - 4.0;
      double z = height(x, y) + 0.02 + 1.5 * random.nextDouble();
      double heading = 2.0 * Math.PI * random.nextDouble();
      double dx = Math.sin(heading);
      double dy = Math.cos(heading);
      double dz = 0.1 - random.nextDouble();
      double hit = RAMP.meets(x, y, z, dx, dy, dz, null);
      double stepped = firstUnder(x, y, z, dx, dy, dz, Math.min(hit, 20.0) + 0.1);
      if (hit < Double.POSITIVE_INFINITY) {
        met++;
        assertThat(stepped).as("ray " + i).isBetween(hit - 0.002, hit + 0.1);
      } else {
        assertThat(stepped).as("ray " + i).isInfinite();
      }
    }
    assertThat(met).isBetween(40, 360);
  }

  private static double height(double x, double y) {
    return Math.abs(x) > 2.0 ? 0.0 : Math.max(0.0, Math.min(0.45, 0.15 * Math.min(y, 7.0 - y)));
  }

  /** Deeper than half a millimetre: a ray may graze an edge. */
  private static double firstUnder(
      double x, double y, double z, double dx, double dy, double dz, double upTo) {
    for (double t = 0.0; t < upTo && z + t * dz > 0.0; t += 0.001) {
      if (z + t * dz < height(x + t * dx, y + t * dy) - 5.0e-4) {
        return t;
      }
    }
    return Double.POSITIVE_INFINITY;
  }
}
