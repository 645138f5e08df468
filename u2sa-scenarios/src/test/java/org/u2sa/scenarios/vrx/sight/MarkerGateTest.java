package org.u2sa.scenarios.vrx.sight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

/** North, east. */
class MarkerGateTest {
  private static MarkerGate.Port port(double north, double east, MarkerGate.Place place) {
    return new MarkerGate.Port(Point.of(north, east, 0.0), place);
  }

  @Test
  void among_markersOfTwoGates_pairsTheNearest() {
    List<MarkerGate> gates =
        MarkerGate.among(
            List.of(
                port(0.0, -8.0, MarkerGate.Place.FIRST), port(30.0, -8.0, MarkerGate.Place.LAST)),
            List.of(Point.of(0.0, 8.0, 0.0), Point.of(33.0, 10.0, 0.0)));

    assertThat(gates)
        .extracting(MarkerGate::place)
        .containsExactly(MarkerGate.Place.FIRST, MarkerGate.Place.LAST);
    assertThat(gates.get(0).way().distanceTo(Point.of(1.0, 0.0, 0.0))).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void among_markerWhosePartnerIsUnseen_isNoGate() {
    assertThat(
            MarkerGate.among(
                List.of(
                    port(0.0, -8.0, MarkerGate.Place.FIRST),
                    port(20.0, -8.0, MarkerGate.Place.BETWEEN)),
                List.of(Point.of(0.0, 8.0, 0.0))))
        .hasSize(1);
  }

  @Test
  void isPassed_throughInItsDirection_only() {
    MarkerGate gate =
        new MarkerGate(Point.of(0.0, -8.0, 0.0), Point.of(0.0, 8.0, 0.0), MarkerGate.Place.BETWEEN);

    assertThat(gate.isPassed(Point.of(-1.0, 2.0, 0.0), Point.of(0.5, 2.0, 0.0))).isTrue();
    assertThat(gate.isPassed(Point.of(1.0, 2.0, 0.0), Point.of(-0.5, 2.0, 0.0))).isFalse();
    assertThat(gate.isPassed(Point.of(-1.0, 9.0, 0.0), Point.of(0.5, 9.0, 0.0))).isFalse();
  }
}
