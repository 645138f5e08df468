package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A square of 4 m that stands on a corner, around the origin. */
class PlanarShapeTest {
  private final PlanarShape square =
      PlanarShape.wall(
          "square", new double[] {2.0, 0.0, -2.0, 0.0}, new double[] {0.0, 2.0, 0.0, -2.0});

  @ParameterizedTest
  @CsvSource({
    "-5, 0.5, 5, 0.5, true",
    "-5, 0, 5, 0, true", // from corner to corner
    "0, -5, 0, 5, true",
    "0, 0, 5, 1, true", // out of it
    "-5, 2.5, 5, 2.5, false",
    "-1, 0.2, 1, 0.2, false", // inside
    "5, 5, 3, 9, false"
  })
  void isCrossedBy_waysThroughAndBeside_theOutline(
      double north, double east, double toNorth, double toEast, boolean crosses) {
    assertThat(square.isCrossedBy(north, east, toNorth, toEast)).isEqualTo(crosses);
    assertThat(square.isCrossedBy(toNorth, toEast, north, east)).isEqualTo(crosses);
  }
}
