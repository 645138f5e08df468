package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.RouteTrack;

/** A rover with a route of 8 m to the north. */
class FollowingTest {
  private final AvoidanceBench bench = new AvoidanceBench();
  private final RouteTrack track = new RouteTrack(AvoidanceBench.northward(8.0, 8.0));
  private final Following following = new Following(track, new ProgressWatch(0L));
  private final double stuckS = bench.settings.stuckAfter();

  private boolean isStuck(double seconds, double northM) {
    track.follow(northM, 0.0, 0.1, 1.0);
    return following.isStuck(bench.at(seconds, northM, 0.0));
  }

  @Test
  void choose_free_movesAlongTheRoute() {
    ArcChoice choice = following.choose(bench.arcs(bench.at(0.0)), bench.at(0.0));

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.FOLLOW);
    assertThat(choice.northM()).isPositive();
    assertThat(following.isAlong(track)).isTrue();
    assertThat(following.isAlong(new RouteTrack(AvoidanceBench.northward(8.0, 8.0)))).isFalse();
  }

  @Test
  void isStuck_noProgress_afterTheTimeAllowed() {
    assertThat(isStuck(0.0, 0.0)).isFalse();
    assertThat(isStuck(stuckS - 0.1, 0.0)).isFalse();
    assertThat(isStuck(stuckS, 0.0)).isTrue();
  }

  @Test
  void isStuck_progress_timeBeginsAgain() {
    isStuck(0.0, 0.0);
    assertThat(isStuck(stuckS - 0.1, 1.0)).isFalse();

    assertThat(isStuck(2.0 * stuckS - 0.2, 1.0)).isFalse();
    assertThat(isStuck(2.0 * stuckS - 0.1, 1.0)).isTrue();
  }

  @Test
  void isStuck_descendsInPlace_isProgress() {
    bench.height(5.0);
    isStuck(0.0, 0.0);
    bench.height(4.0);
    assertThat(isStuck(stuckS - 0.1, 0.0)).isFalse();

    assertThat(isStuck(2.0 * stuckS - 0.2, 0.0)).isFalse();
    assertThat(isStuck(2.0 * stuckS - 0.1, 0.0)).isTrue();
  }

  @Test
  void leaveOut_heldByTraffic_thatTimeDoesNotCount() {
    isStuck(0.0, 0.0);
    following.leaveOut(AvoidanceBench.micros(5.0));

    assertThat(isStuck(stuckS + 4.9, 0.0)).isFalse();
    assertThat(isStuck(stuckS + 5.0, 0.0)).isTrue();
  }

  @Test
  void givesUp_descendsInPlace_isProgress() {
    double allowedS = 4.0 * (8.0 + 5.0) + 3.0 * stuckS; // at 1 m/s, with two attempts
    bench.height(5.0);
    following.givesUp(bench.at(0.0));
    bench.height(4.0);
    assertThat(following.givesUp(bench.at(allowedS))).isEmpty();

    assertThat(following.givesUp(bench.at(allowedS + 1.0))).isEmpty();
  }

  @Test
  void givesUp_noNearerForFourTimesTheRoute_saysForHowLong() {
    following.givesUp(bench.at(0.0));
    double allowedS = 4.0 * 8.0 + 3.0 * stuckS; // at 1 m/s, with two attempts

    assertThat(following.givesUp(bench.at(allowedS))).isEmpty();
    assertThat(following.givesUp(bench.at(allowedS + 1.0)).orElseThrow())
        .startsWith("no closer to the goal for ");
  }
}
