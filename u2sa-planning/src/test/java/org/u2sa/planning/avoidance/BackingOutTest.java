package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.planning.local.ArcChoice;

/** A rover that backs out for two seconds. */
class BackingOutTest {
  private final AvoidanceBench bench = new AvoidanceBench();
  private final Searching search = new Searching(bench.routes, 0L);
  private final BackingOut backing = new BackingOut(AvoidanceBench.micros(2.0), search, false);
  private final double giveUpS = bench.settings.giveUpAfter();

  @Test
  void choose_freeBehind_reversesOneAndAHalfRadii() {
    Situation now = bench.at(0.0);
    ArcChoice choice = backing.choose(bench.arcs(now), now);

    assertThat(choice.backwards()).isTrue();
    assertThat(Math.hypot(choice.northM(), choice.eastM()))
        .isBetween(1.4 * now.body().circleM(), 1.5001 * now.body().circleM());
  }

  @Test
  void choose_aheadOnly_drivesAhead() {
    Situation now = bench.at(0.0);
    ArcChoice choice =
        new BackingOut(AvoidanceBench.micros(2.0), search, true).choose(bench.arcs(now), now);

    assertThat(choice.backwards()).isFalse();
    assertThat(Math.hypot(choice.northM(), choice.eastM())).isPositive();
  }

  @Test
  void at_timeIsUp_searches() {
    assertThat(backing.at(AvoidanceBench.micros(1.9))).isSameAs(backing);
    assertThat(backing.at(AvoidanceBench.micros(2.0))).isSameAs(search);
  }

  @Test
  void givesUp_asTheSearchThatHasBegun() {
    backing.leaveOut(AvoidanceBench.micros(1.0));

    assertThat(backing.isStuck(bench.at(giveUpS))).isFalse();
    assertThat(backing.givesUp(bench.at(giveUpS))).isEmpty();
    assertThat(backing.givesUp(bench.at(giveUpS + 1.0))).isPresent();
  }
}
