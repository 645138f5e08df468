package org.u2sa.sim.performance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class PureMotionTest {
  private static final int AHEAD = 0;
  private static final int RIGHT = 1;
  private static final int TURN = 2;

  private static double[][] thruster(double ahead, double right, double turn, double reverse) {
    double[] back = {-reverse * ahead, -reverse * right, -reverse * turn};
    return new double[][] {{ahead, right, turn}, back};
  }

  private static final double[][] PORT = thruster(1.0, 0.0, 0.5, 0.8);
  private static final double[][] STARBOARD = thruster(1.0, 0.0, -0.5, 0.8);
  private static final double[][] BOW = thruster(0.0, 0.5, 0.4, 1.0);

  @Test
  void along_equalThrusters_useBothInFull() {
    PureMotion boat = new PureMotion(new double[][][] {PORT, STARBOARD, BOW});

    assertThat(boat.along(AHEAD, 1.0, List.of(TURN, RIGHT))).containsExactly(1.0, 1.0, 0.0);
    assertThat(boat.along(AHEAD, -1.0, List.of(TURN, RIGHT))).containsExactly(-1.0, -1.0, 0.0);
  }

  @Test
  void along_sideways_othersStopTheTurnWithoutPushingAhead() {
    PureMotion boat = new PureMotion(new double[][][] {PORT, STARBOARD, BOW});

    double[] shares = boat.along(RIGHT, 1.0, List.of(TURN, AHEAD));

    assertThat(shares[2]).isEqualTo(1.0);
    // 0.4 of turn, half each; astern a thruster has 0.8 of its effect ahead
    assertThat(shares[0]).isCloseTo(-0.5, within(0.01));
    assertThat(shares[1]).isCloseTo(0.4, within(0.01));
  }

  @Test
  void along_oneStrongerThruster_isHeldBack() {
    double[][] strong = thruster(1.25, 0.0, -0.625, 0.8);

    double[] shares =
        new PureMotion(new double[][][] {PORT, strong}).along(AHEAD, 1.0, List.of(TURN));

    assertThat(shares[0]).isEqualTo(1.0);
    assertThat(shares[1]).isCloseTo(0.8, within(0.005));
  }

  @Test
  void along_turnThatOnlyTheWholeEffectWouldStop_isAccepted() {
    double[] shares = new PureMotion(new double[][][] {PORT}).along(AHEAD, 1.0, List.of(TURN));

    assertThat(shares).containsExactly(1.0);
  }
}
