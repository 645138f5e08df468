package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.search.GridFrame;

/** Ground under a level flight at 60 m that keeps 10 m above it. */
class GroundLayerTest {
  private static final GridFrame FRAME = GridFrame.around(0.0, 0.0, 5.0, 1000.0);
  private static final FlightProfile LEVEL = new FlightProfile(0.0, 0.0, -60.0, -60.0, 0.1, 10.0);

  private static DoubleBinaryOperator hill(double northM, double eastM, double lengthRatio) {
    return (north, east) ->
        -100.0 * Math.exp(-Math.hypot(north - northM, (east - eastM) / lengthRatio) / 50.0);
  }

  private static GroundLayer layer(FlightProfile flown, DoubleBinaryOperator ground) {
    return GroundLayer.of(flown, ground, FRAME, null);
  }

  @Test
  void isHigh_hill_whereTheGroundIsAbove50M() {
    GroundLayer layer = layer(LEVEL, hill(200.0, 0.0, 1.0));

    assertThat(layer.isHigh(FRAME.indexAt(230.0, 0.0))).isTrue();
    assertThat(layer.isHigh(FRAME.indexAt(240.0, 0.0))).isFalse();
  }

  @Test
  void isHigh_climb_countsWhatIsNotYetPassed() {
    FlightProfile climb = new FlightProfile(0.0, 0.0, -60.0, -160.0, 0.1, 10.0);

    assertThat(layer(climb, hill(200.0, 0.0, 1.0)).shapes()).hasSize(1);
    assertThat(layer(climb, hill(0.0, 499.0, 1.0)).shapes()).isEmpty();
  }

  @Test
  void isHigh_unknownGround_isFree() {
    assertThat(layer(LEVEL, (north, east) -> Double.NaN).shapes()).isEmpty();
  }

  @Test
  void of_sameProfile_isTheLayerBefore() {
    GroundLayer layer = layer(LEVEL, hill(200.0, 0.0, 1.0));

    assertThat(GroundLayer.of(LEVEL, (n, e) -> 0.0, FRAME, layer)).isSameAs(layer);
  }

  @Test
  void shapes_roundHillAndRidge_areADiscAndAPolygonAroundThem() {
    DoubleBinaryOperator round = hill(250.0, 0.0, 1.0);
    DoubleBinaryOperator ridge = hill(-250.0, 0.0, 8.0);
    GroundLayer layer =
        layer(LEVEL, (n, e) -> Math.min(round.applyAsDouble(n, e), ridge.applyAsDouble(n, e)));
    List<PlanarShape> shapes = layer.shapes();

    assertThat(shapes)
        .extracting(PlanarShape::kind)
        .containsExactly(PlanarShape.Kind.AREA, PlanarShape.Kind.POINTS);
    for (int i = 0; i < FRAME.cells(); i++) {
      double north = FRAME.centreNorthM(i);
      double east = FRAME.centreEastM(i);
      boolean isInside = shapes.stream().anyMatch(shape -> shape.distanceM(north, east) == 0.0);
      assertThat(!layer.isHigh(i) || isInside).isTrue();
    }
    assertThat(shapes.get(0).distanceM(-250.0, 300.0)).isBetween(1.0, 30.0);
    assertThat(shapes.get(1).radiusM()).isBetween(35.0, 45.0);
  }

  /** Otherwise searches around them would take long. */
  @Test
  void shapes_manyHills_areTheLargestOnly() {
    GroundLayer layer =
        layer(LEVEL, (n, e) -> -60.0 * Math.max(0.0, Math.sin(n / 10.0) * Math.sin(e / 15.0)));

    assertThat(layer.shapes().stream().mapToInt(PlanarShape::count).sum()).isBetween(20, 40);
  }
}
