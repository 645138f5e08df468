package org.u2sa.estimation.rotation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class MotionHeadingTest {
  private static final double STEP_S = 0.1;

  private final double[] x = new double[MotionHeading.SIZE];
  private final Random random = new Random(1);
  private double north;
  private double east;

  /** Accelerates while the estimate's heading is wrong by an angle. */
  private void fly(double seconds, double mps2, double wrongRad, double scale) {
    for (int i = 0; i < seconds / STEP_S; i++) {
      double course = 0.7 * i * STEP_S;
      double an = mps2 * Math.cos(course);
      double ae = mps2 * Math.sin(course);
      north += an * STEP_S;
      east += ae * STEP_S;
      double cos = scale * Math.cos(wrongRad);
      double sin = scale * Math.sin(wrongRad);
      MotionHeading.accelerate(x, cos * an - sin * ae, cos * ae + sin * an, STEP_S);
      double vn = north + 0.05 * random.nextGaussian();
      MotionHeading.velocity(x, 0, vn, east + 0.05 * random.nextGaussian(), 0.0025);
    }
  }

  @Property(tries = 200)
  void errorRad_turnsInTheAir_isTheHeadingsError(
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double wrongRad) {
    Arrays.fill(x, 0.0);
    fly(10.0, 2.0, wrongRad, 1.0);

    double apart = Math.IEEEremainder(MotionHeading.errorRad(x) + wrongRad, 2.0 * Math.PI);
    assertThat(apart).isCloseTo(0.0, within(3.0 * MotionHeading.sigmaRad(x)));
    assertThat(MotionHeading.refutes(x, -wrongRad)).isFalse();
    assertThat(MotionHeading.refutes(x, -wrongRad + 0.6)).isTrue();
  }

  @Test
  void corrected_byTheError_agrees() {
    fly(10.0, 2.0, 1.0, 1.0);
    assertThat(MotionHeading.refutes(x, 0.0)).isTrue();

    MotionHeading.corrected(x, MotionHeading.errorRad(x));

    assertThat(MotionHeading.errorRad(x)).isCloseTo(0.0, within(1e-9));
    assertThat(MotionHeading.refutes(x, 0.0)).isFalse();
  }

  @Test
  void corrected_inTheMiddle_isNoEvidenceOfAnotherHeading() {
    fly(5.0, 2.0, 0.5, 1.0);
    MotionHeading.corrected(x, -0.5);
    fly(5.0, 2.0, 0.0, 1.0);

    assertThat(MotionHeading.errorRad(x)).isCloseTo(0.0, within(0.15));
  }

  @Test
  void refutes_forcesOfAnotherSize_isNoEvidence() {
    fly(10.0, 2.0, 1.0, 0.4);

    assertThat(MotionHeading.refutes(x, 0.0)).isFalse();
    assertThat(MotionHeading.refutes(x, 1.0)).isFalse();
  }

  @Test
  void refutes_steadyFlight_isForgotten() {
    fly(10.0, 2.0, 1.0, 1.0);
    assertThat(MotionHeading.refutes(x, 0.0)).isTrue();

    fly(20.0, 0.0, 1.0, 1.0);

    assertThat(MotionHeading.refutes(x, 0.0)).isFalse();
  }

  @Test
  void refutes_receiverFallsSilent_isNot() {
    fly(10.0, 2.0, 1.0, 1.0);

    MotionHeading.accelerate(x, 0.0, 0.0, 3.1);

    assertThat(MotionHeading.refutes(x, 0.0)).isFalse();
  }
}
