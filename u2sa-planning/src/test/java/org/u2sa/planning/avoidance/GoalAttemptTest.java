package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChoice.Kind;
import org.u2sa.planning.route.Route;

/** What a vehicle does on the way to its goal, 8 m to the north, if it does not move. */
class GoalAttemptTest {
  private final AvoidanceBench bench = new AvoidanceBench();
  private final GoalAttempt attempt =
      new GoalAttempt(
          bench.routes,
          bench.passages,
          bench::say,
          AvoidanceBench.micros(0.0),
          AvoidanceBench.micros(0.0));
  private final double stuckS = bench.settings.stuckAfter();
  private final double giveUpS = bench.settings.giveUpAfter();
  private final double overlookS = bench.settings.overlookAfter();

  private ArcChoice step(double seconds) {
    return bench.step(attempt, bench.at(seconds));
  }

  private Optional<String> judge(double seconds, boolean trafficNear) {
    Situation now = bench.at(seconds);
    return attempt.judge(bench.step(attempt, now), trafficNear, now, now.micros());
  }

  private Optional<String> judge(double seconds) {
    return judge(seconds, false);
  }

  private boolean overlooks(double seconds) {
    return attempt.overlooks(bench.settings, AvoidanceBench.micros(seconds));
  }

  private void loseRoute(double seconds) {
    bench.answer = Route.none("a wall");
    bench.see(AvoidanceBench.post(4.0, 0.0));
    judge(seconds);
  }

  @Test
  void choose_routeFound_followsIt() {
    ArcChoice choice = step(0.0);

    assertThat(choice.kind()).isEqualTo(Kind.FOLLOW);
    assertThat(choice.northM()).isPositive();
  }

  @Test
  void choose_noRoute_waits() {
    bench.answer = Route.none("a wall");

    assertThat(step(0.0).kind()).isEqualTo(Kind.WAIT);
    assertThat(step(2.0 * overlookS).speedMps()).isZero();
  }

  @Test
  void choose_noRouteForLong_looksAround() {
    bench.answer = Route.none("a wall");
    step(0.0);

    ArcChoice looks = step(2.0 * overlookS + 0.1);

    assertThat(Math.atan2(looks.eastM(), looks.northM()))
        .isCloseTo(Math.toRadians(60.0), within(1.0e-9));
  }

  @Test
  void judge_noRoute_givesUpInTimeWithThePlannersReason() {
    bench.answer = Route.none("a wall");
    assertThat(judge(0.0)).isEmpty();

    assertThat(judge(giveUpS - 0.1)).isEmpty();
    assertThat(judge(giveUpS)).contains("a wall");
  }

  @Test
  void judge_searchThatDoesNotEnd_givesUpAndSaysSo() {
    bench.answer = Route.sought();
    judge(0.0);

    assertThat(judge(giveUpS)).contains("no way to the goal was found in time");
  }

  @Test
  void judge_routeLost_timeToGiveUpBeginsThen() {
    judge(0.0);
    loseRoute(2.0);

    assertThat(judge(2.0 + giveUpS - 0.1)).isEmpty();
    assertThat(judge(2.0 + giveUpS)).contains("a wall");
  }

  @Test
  void judge_noProgressAlongTheRoute_backsOutForAThirdOfTheTimeThenPlansAgain() {
    judge(0.0);
    judge(stuckS - 0.1);
    assertThat(attempt.hasRecovered()).isFalse();

    assertThat(judge(stuckS)).isEmpty();
    assertThat(attempt.hasRecovered()).isTrue();
    assertThat(bench.said).containsExactly("stuck: freeing itself, attempt 1 of 2");
    int planned = bench.requests.size();

    ArcChoice back = step(1.3 * stuckS);
    assertThat(back.backwards()).isTrue();
    assertThat(bench.requests).hasSize(planned);

    assertThat(step(stuckS * 4.0 / 3.0).kind()).isEqualTo(Kind.FOLLOW);
    assertThat(bench.requests).hasSize(planned + 1);
  }

  @Test
  void judge_stuckMoreOftenThanAllowed_givesUp() {
    Optional<String> reason = Optional.empty();
    double seconds = 0.0;
    while (reason.isEmpty() && seconds < 20.0 * stuckS) {
      reason = judge(seconds);
      seconds += 0.1;
    }

    assertThat(bench.said)
        .containsExactly(
            "stuck: freeing itself, attempt 1 of 2", "stuck: freeing itself, attempt 2 of 2");
    assertThat(reason).contains("stuck after 2 attempts to free itself");
  }

  @Test
  void judge_heldUpByTraffic_thatTimeDoesNotCount() {
    bench.answer = Route.none("traffic");
    for (double seconds = 0.0; seconds <= giveUpS + 5.0; seconds += 0.5) {
      assertThat(judge(seconds, true)).as("at %s s", seconds).isEmpty();
    }
    assertThat(judge(giveUpS + 5.0 + giveUpS + 0.5)).contains("traffic");
  }

  @Test
  void overlooks_noRouteForAWhile_triesThroughWhatIsGuessedAndSaysSoOnce() {
    bench.answer = Route.none("a wall");
    judge(0.0);
    int planned = bench.requests.size();

    assertThat(overlooks(overlookS)).isFalse();
    assertThat(overlooks(overlookS + 0.1)).isTrue();
    assertThat(overlooks(overlookS + 0.2)).isTrue();
    assertThat(bench.said).containsExactly("no route: passing through doubtful obstacles");
    judge(overlookS + 0.2);
    assertThat(bench.requests).hasSize(planned + 1);
  }

  @Test
  void overlooks_routeFoundAgain_lastsAsLongOnce() {
    bench.answer = Route.none("a wall");
    judge(0.0);
    overlooks(overlookS + 1.0);
    bench.answer = AvoidanceBench.northward(8.0, 8.0);
    judge(overlookS + 1.0);

    assertThat(overlooks(2.0 * overlookS + 0.9)).isTrue();
    assertThat(overlooks(2.0 * overlookS + 1.0)).isFalse();
  }

  @Test
  void overlooks_routeExists_never() {
    judge(0.0);

    assertThat(overlooks(100.0)).isFalse();
  }

  /** Beside a post, where it cannot turn, with a route to the rear of this cost. */
  private void leadBack(double cost, double seenNorthOfM) {
    bench.turnsOnTheSpot = true;
    bench.seeNorthOf(seenNorthOfM);
    bench.see(AvoidanceBench.post(0.0, 0.45));
    bench.answer = southward(cost);
  }

  private static Route southward(double cost) {
    return Route.of(
        List.of(new Route.Point(0.0, 0.0, false), new Route.Point(-8.0, 0.0, false)), cost);
  }

  @Test
  void choose_routeBackWhereNothingWasSeen_goesAheadUntilARouteLeadsThere() {
    leadBack(8.0, -0.2);
    ArcChoice ahead = step(0.0);
    bench.answer = Route.none("a wall");
    ArcChoice goesOn = step(1.0);
    bench.answer = AvoidanceBench.northward(8.0, 20.0);
    ArcChoice follows = step(2.0);

    assertThat(ahead.backwards()).isFalse();
    assertThat(ahead.northM()).isPositive();
    assertThat(goesOn.northM()).isPositive();
    assertThat(follows.kind()).isEqualTo(Kind.FOLLOW);
    assertThat(bench.said)
        .containsExactly("the way leads back, where nothing was seen: trying the way ahead");
  }

  @Test
  void choose_noRouteAhead_backsOutAfterSomeSeconds() {
    leadBack(8.0, -0.2);
    step(0.0);
    bench.answer = Route.none("a wall");
    step(4.5);
    bench.answer = southward(8.0);
    ArcChoice back = step(5.5);

    assertThat(back.kind()).isEqualTo(Kind.MAKE_ROOM);
    assertThat(back.backwards()).isTrue();
  }

  @Test
  void choose_routeBackOverSeenGround_backsOutAtOnce() {
    leadBack(8.0, -9.0);

    assertThat(step(0.0).backwards()).isTrue();
    assertThat(bench.said).isEmpty();
  }
}
