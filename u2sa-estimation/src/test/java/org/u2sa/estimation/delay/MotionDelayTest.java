package org.u2sa.estimation.delay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** A receiver with five velocities a second, on a vehicle that accelerates to and fro. */
class MotionDelayTest {
  private static final double DT = 0.01;
  private static final double SIGMA = 0.05;

  private final double[] path = new double[InertialPath.SIZE];
  private final double[] x = new double[MotionDelay.SIZE];
  private final MotionDelay delay = new MotionDelay();
  private final Random random = new Random(7);
  private final double[][] then = new double[200][];
  private double turned; // of the forces against the velocities [rad]
  private double wrong; // acceleration shown in error from 10 s on [m/s²]
  private boolean isSteady;

  private void move(double seconds, double lateS) {
    double[] v = new double[3];
    for (int i = 1; i <= Math.round(seconds / DT); i++) {
      double t = i * DT;
      double north = isSteady ? 0.0 : 2.0 * Math.sin(1.3 * t);
      double east = isSteady ? 0.0 : 1.5 * Math.sin(0.7 * t + 1.0);
      double down = isSteady ? 0.0 : Math.sin(0.9 * t);
      v[0] += DT * north;
      v[1] += DT * east;
      v[2] += DT * down;
      then[i % then.length] = v.clone();
      double shown = north + (t >= 10.0 ? wrong : 0.0);
      double cos = Math.cos(turned);
      double sin = Math.sin(turned);
      InertialPath.advance(path, t, DT, cos * shown - sin * east, sin * shown + cos * east, down);
      if (i % 20 == 0) {
        int late = Math.max(1, i - (int) Math.round(lateS / DT));
        double[] z = then[late % then.length].clone();
        for (int k = 0; k < 3; k++) {
          z[k] += SIGMA * random.nextGaussian();
        }
        delay.velocity(x, 0, path, t, z, SIGMA);
        isEverRefuted |= MotionDelay.refutes(x, 0, 0.0);
      }
    }
  }

  private boolean isEverRefuted;

  @Test
  void meanS_late_isThatDelay() {
    move(20.0, 0.37);
    assertThat(MotionDelay.meanS(x, 0)).isCloseTo(0.37, within(0.03));
    assertThat(MotionDelay.variance(x, 0)).isLessThan(0.05 * 0.05);
    assertThat(MotionDelay.refutes(x, 0, 0.0)).isTrue();
    assertThat(MotionDelay.refutes(x, 0, 0.37)).isFalse();
  }

  @Test
  void meanS_inTime_isNone() {
    move(20.0, 0.0);
    assertThat(MotionDelay.meanS(x, 0)).isLessThan(0.03);
    assertThat(isEverRefuted).isFalse();
  }

  @Test
  void meanS_headingOfTheForcesWrong_isThatDelay() {
    turned = 1.0;
    move(30.0, 0.3);
    assertThat(MotionDelay.meanS(x, 0)).isCloseTo(0.3, within(0.05));
  }

  @Test
  void refutes_steadyMotion_showsNothing() {
    isSteady = true;
    move(20.0, 0.5);
    assertThat(isEverRefuted).isFalse();
    assertThat(MotionDelay.variance(x, 0)).isGreaterThan(0.1 * 0.1);
  }

  /** The most delayed path sees the fault last, but that does not make it right. */
  @Test
  void refutes_forcesWrongAllOfASudden_isNoDelay() {
    wrong = 1.0;
    move(20.0, 0.0);
    assertThat(isEverRefuted).isFalse();
  }
}
