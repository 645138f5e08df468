package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.ArcChoice.Kind;
import org.u2sa.planning.seen.Mover;

/** Which time counts as held up by traffic. */
class TrafficHoldTest {
  private static final long STEP = Clock.micros(0.5);

  private final TrafficHold hold = new TrafficHold(0, 0);

  @Test
  void pass_waitsOrBacksOffBesideTraffic_timeIsHeld() {
    assertThat(hold.pass(Kind.WAIT, true, STEP, STEP)).isEqualTo(STEP);
    assertThat(hold.pass(Kind.EVADE, true, 2 * STEP, 2 * STEP)).isEqualTo(STEP);
  }

  @Test
  void pass_followsItsRouteOrNobodyIsNear_timeCounts() {
    assertThat(hold.pass(Kind.FOLLOW, true, STEP, STEP)).isZero();
    assertThat(hold.pass(Kind.WAIT, false, 2 * STEP, 2 * STEP)).isZero();
  }

  @Test
  void pass_trafficStaysForMinutes_patienceEnds() {
    long held = 0;
    for (int i = 1; i <= 2000; i++) {
      held += hold.pass(Kind.WAIT, true, i * STEP, i * STEP);
    }
    assertThat(Clock.seconds(held)).isEqualTo(300.0);
  }

  @Test
  void isNear_byDistanceAndSpeed_looksAsFarAsItCanCome() {
    Pose at = new Pose(0.0, 0.0, 0.0);
    List<Mover> slow = List.of(walker(4.0, 0.3));
    List<Mover> fast = List.of(walker(4.0, 1.0));
    assertThat(TrafficHold.isNear(slow, at, 1.0, 4.0, 0)).isFalse();
    assertThat(TrafficHold.isNear(fast, at, 1.0, 4.0, 0)).isTrue();
    assertThat(TrafficHold.isNear(List.of(), at, 1.0, 4.0, 0)).isFalse();
  }

  private static Mover walker(double northM, double mps) {
    return new Mover("W", 0, 0.0, new double[] {northM}, new double[] {0.0}, -mps, 0.0, 0.3);
  }
}
