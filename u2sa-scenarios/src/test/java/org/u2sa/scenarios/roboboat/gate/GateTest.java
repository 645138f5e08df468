package org.u2sa.scenarios.roboboat.gate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class GateTest {
  private static final Gate NORTHWARD =
      new Gate(Point.of(10.0, -1.0, 0.0), Point.of(10.0, 1.0, 0.0));

  @Test
  void way_leftBuoyInTheWest_leadsNorth() {
    assertThat(NORTHWARD.way().x()).isCloseTo(1.0, within(1e-9));
    assertThat(NORTHWARD.way().y()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void isPassed_throughTheMiddleNorthward_isTrue() {
    assertThat(NORTHWARD.isPassed(Point.of(9.5, 0.2, 0.0), Point.of(10.2, 0.2, 0.0))).isTrue();
  }

  @Test
  void isPassed_southward_isFalse() {
    assertThat(NORTHWARD.isPassed(Point.of(10.2, 0.2, 0.0), Point.of(9.5, 0.2, 0.0))).isFalse();
  }

  @Test
  void isPassed_besideABuoy_isFalse() {
    assertThat(NORTHWARD.isPassed(Point.of(9.5, 1.2, 0.0), Point.of(10.2, 1.2, 0.0))).isFalse();
  }

  @Test
  void among_aBuoyWithoutPartner_isLeftOut() {
    List<Point> lefts = List.of(Point.of(10.0, -1.0, 0.0), Point.of(30.0, -1.0, 0.0));

    assertThat(Gate.among(lefts, List.of(Point.of(10.0, 1.0, 0.0)))).containsExactly(NORTHWARD);
  }

  @Property
  void beyond_anyGate_liesOnItsAxis(
      @ForAll @DoubleRange(min = -50, max = 50) double north,
      @ForAll @DoubleRange(min = -50, max = 50) double east,
      @ForAll @DoubleRange(min = -20, max = 20) double metres) {
    Gate gate = new Gate(Point.of(north, east, 0.0), Point.of(north + 1.3, east + 2.1, 0.0));
    Point beyond = gate.beyond(metres);

    assertThat(gate.asideM(beyond)).isCloseTo(0.0, within(1e-9));
    assertThat(gate.aheadM(beyond)).isCloseTo(-metres, within(1e-9));
  }
}
