package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.route.Route;

/** A rover without a route since time 0. */
class SearchingTest {
  private final AvoidanceBench bench = new AvoidanceBench();
  private final Searching searching = new Searching(bench.routes, 0L);
  private final double overlookS = bench.settings.overlookAfter();
  private final double giveUpS = bench.settings.giveUpAfter();

  private ArcChoice choose(double seconds) {
    Situation now = bench.at(seconds);
    return searching.choose(bench.arcs(now), now);
  }

  @Test
  void choose_first_waits() {
    ArcChoice choice = choose(0.1);

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.WAIT);
    assertThat(choice.speedMps()).isZero();
  }

  @Test
  void choose_twiceTheTimeOfDoubt_looksAround() {
    assertThat(choose(2.0 * overlookS).speedMps()).isZero();
    assertThat(choose(2.0 * overlookS + 0.1).speedMps()).isPositive();
  }

  @Test
  void doubtsObstacles_afterAWhile() {
    long overlook = bench.settings.overlookMicros();
    assertThat(searching.doubtsObstacles(bench.settings, overlook)).isFalse();
    assertThat(searching.doubtsObstacles(bench.settings, overlook + 1)).isTrue();
  }

  @Test
  void givesUp_inTime_withTheObstacleOrThatTheSearchGoesOn() {
    bench.answer = Route.none("a wall");
    bench.routes.update(bench.at(0.0));
    assertThat(searching.givesUp(bench.at(giveUpS - 0.1))).isEmpty();
    assertThat(searching.givesUp(bench.at(giveUpS))).contains("a wall");

    bench.answer = Route.sought();
    bench.routes.tryAgain();
    bench.routes.update(bench.at(giveUpS));
    assertThat(searching.givesUp(bench.at(giveUpS)))
        .contains("no way to the goal was found in time");
  }

  @Test
  void leaveOut_heldByTraffic_givesUpThatMuchLater() {
    searching.leaveOut(AvoidanceBench.micros(5.0));

    assertThat(searching.givesUp(bench.at(giveUpS + 4.9))).isEmpty();
    assertThat(searching.givesUp(bench.at(giveUpS + 5.0))).isPresent();
  }
}
