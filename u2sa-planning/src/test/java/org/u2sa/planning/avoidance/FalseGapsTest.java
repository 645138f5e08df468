package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.avoidance.VirtualObstacles.FalseGaps;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

/** A route eight metres to the north, from the origin, for a vehicle that needs 0.6 m around it. */
class FalseGapsTest {
  private static final double RADIUS = 0.6;

  private final CostGrid costs =
      new CostGrid(new GridFrame(-5.0, -5.0, 0.1, 150, 100), new Inflation(RADIUS, 1.4, 3.0));
  private final RouteTrack route =
      new RouteTrack(
          Route.of(List.of(new Route.Point(0.0, 0.0, false), new Route.Point(8.0, 0.0, false)), 8));
  private final FalseGaps gaps = new FalseGaps();

  private void postAt(double northM) {
    GridFrame frame = costs.frame();
    int post = frame.index(frame.row(northM), frame.column(0.3));
    costs.update(i -> i == post, i -> false);
  }

  private void blockedAfter(double seconds) {
    gaps.blocked(route, costs, Clock.micros(seconds));
  }

  @Test
  void blocked_once_nothingCountsAsClosed() {
    postAt(2.5);
    blockedAfter(10.0);
    assertThat(gaps.shapes()).isEmpty();
  }

  @Test
  void blocked_againAtTheSamePlace_countsAsClosedThere() {
    postAt(2.5);
    blockedAfter(10.0);
    postAt(2.6); // errors of the scanner
    blockedAfter(20.0);
    assertThat(gaps.shapes()).hasSize(1);
    assertThat(gaps.shapes().get(0).northM(0))
        .isCloseTo(2.1, within(0.2)); // where the vehicle stops
    assertThat(gaps.shapes().get(0).eastM(0)).isZero();
  }

  @Test
  void blocked_againElsewhere_nothingCountsAsClosed() {
    postAt(2.0);
    blockedAfter(10.0);
    postAt(3.5);
    blockedAfter(20.0);
    assertThat(gaps.shapes()).isEmpty();
  }

  @Test
  void blocked_againInTheSameAttempt_nothingCountsAsClosed() {
    postAt(2.5);
    blockedAfter(10.0);
    blockedAfter(12.9);
    assertThat(gaps.shapes()).isEmpty();
  }

  @Test
  void blocked_farAheadOrRightBefore_nothingCountsAsClosed() {
    for (double north : new double[] {4.0, 1.2}) {
      postAt(north);
      blockedAfter(10.0);
      blockedAfter(20.0);
    }
    assertThat(gaps.shapes()).isEmpty();
  }

  @Test
  void forget_afterClosing_opensAndCountsAnew() {
    postAt(2.5);
    blockedAfter(10.0);
    blockedAfter(20.0);
    gaps.forget();
    blockedAfter(30.0);
    assertThat(gaps.shapes()).isEmpty();
  }
}
