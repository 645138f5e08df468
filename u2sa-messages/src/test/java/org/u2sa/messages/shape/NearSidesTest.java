package org.u2sa.messages.shape;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;

class NearSidesTest {
  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  private static Geometry star(int corners, double innerM, double outerM) {
    Coordinate[] ring = new Coordinate[corners + 1];
    for (int i = 0; i < corners; i++) {
      double radiusM = i % 2 == 0 ? innerM : outerM;
      double angle = 2.0 * Math.PI * i / corners;
      ring[i] = new Coordinate(radiusM * Math.cos(angle), radiusM * Math.sin(angle));
    }
    ring[corners] = ring[0].copy();
    return GEOMETRY.createPolygon(ring);
  }

  private static Geometry square(double x) {
    return GEOMETRY.toGeometry(new Envelope(x, x + 10.0, 0.0, 10.0));
  }

  @Test
  void count_starWithNarrowSpikes_areItsPairsOfSidesUpToTheLimit() {
    assertThat(NearSides.count(star(10, 10.0, 100.0), 1e9, 1_000)).isEqualTo(10 * 9 / 2);
    assertThat(NearSides.count(star(10, 10.0, 100.0), 1e9, 20)).isGreaterThan(20);
    assertThat(NearSides.count(star(10, 100.0, 200.0), 1.0, 1_000)).isEqualTo(10); // neighbours
  }

  @Test
  void count_convexBorder_isNoneHoweverNear() {
    assertThat(NearSides.count(star(64, 10.0, 10.0), 1e9, 1_000)).isZero();
  }

  @Test
  void count_twoSquares_areTheSidesWithinTheDistanceOfTheOther() {
    Geometry both = GEOMETRY.buildGeometry(List.of(square(0.0), square(15.0)));

    assertThat(NearSides.count(both, 4.9, 100)).isZero();
    assertThat(NearSides.count(both, 5.1, 100)).isEqualTo(7);
    assertThat(NearSides.count(both, 1e3, 100)).isEqualTo(16);
  }
}
