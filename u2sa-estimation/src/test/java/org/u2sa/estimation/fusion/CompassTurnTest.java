package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;

/**
 * A rover whose only measured motion is a compass, 20 times a second, turns to and fro in place.
 */
class CompassTurnTest {
  private static final double STEP_S = 0.005;
  private static final double SIGMA_RAD = 0.0175;
  private static final double NOISE_RAD = 0.0052;
  private static final double RAD_PER_S2 = 6.4;
  private static final double PHASE_S = 3.0; // of turning, standing, and turning back

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final Measurement m = new Measurement();
  private double psi = 0.3;
  private double radPerS;
  private double squares;
  private int count;
  private double worst;
  private double worstRate;

  private void turn(double rate, int seed, int frozen, int repeats, double rounding) {
    Random random = new Random(seed);
    double held = 0.0;
    int toHold = 0;
    for (int i = 0; i < 60.0 / STEP_S; i++) {
      double t = i * STEP_S;
      int phase = (int) (t / PHASE_S) % 3;
      double wanted = t < 6.0 ? 0.0 : phase == 0 ? rate : phase == 1 ? 0.0 : -rate;
      double most = RAD_PER_S2 * STEP_S;
      radPerS += Math.max(-most, Math.min(most, wanted - radPerS));
      psi += radPerS * STEP_S;
      long micros = 1_000L + Math.round(t * 1e6);
      if (i % 10 == 0) {
        toHold = i % 460 == 0 ? frozen : toHold - 1; // every 2.3 s
        double shown = psi + NOISE_RAD * random.nextGaussian();
        double rounded = rounding > 0.0 ? rounding * Math.rint(shown / rounding) : shown;
        held = toHold > 0 ? held : rounded;
        compass(micros, held);
      } else if (i % 10 == 4 && repeats > 0 || i % 10 == 8 && repeats > 1) {
        compass(micros, held);
      }
      if (t > 6.0) {
        judge(micros);
      }
    }
  }

  private void compass(long micros, double heading) {
    m.begin("Compass", micros).heading(Math.IEEEremainder(heading, 2.0 * Math.PI), SIGMA_RAD);
    filter.add(m);
  }

  private void judge(long micros) {
    Estimate e = filter.at(micros);
    double off = Math.toDegrees(Math.abs(Math.IEEEremainder(e.psi() - psi, 2.0 * Math.PI)));
    worst = Math.max(worst, off);
    worstRate = Math.max(worstRate, Math.abs(e.headingRate() - radPerS));
    squares += off * off;
    count++;
  }

  private double rmsDeg() {
    return Math.sqrt(squares / count);
  }

  @ParameterizedTest
  @CsvSource({"1, 1.0, 7", "2, 1.3, 13", "3, 1.8, 25", "6, 8, 45"})
  void add_headingFreezesForSomeSamples_turnIsNotLost(int samples, double rms, double most) {
    turn(1.22, 1, samples + 1, 0, 0.0);

    assertThat(rmsDeg()).isLessThan(rms);
    assertThat(worst).isLessThan(most);
  }

  @ParameterizedTest
  @CsvSource({"1.22, 1", "1.22, 2", "2.0, 1", "2.0, 2"})
  void add_eachHeadingIsRepeated_turnIsFollowed(double rate, int repeats) {
    turn(rate, 2, 0, repeats, 0.0);

    assertThat(rmsDeg()).isLessThan(1.6);
    assertThat(worst).isLessThan(10.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_eachHeadingIsRepeatedAndSomeFreeze_turnIsNotLost(int seed) {
    turn(1.22, seed, 3, 1, 0.0);

    assertThat(rmsDeg()).isLessThan(3.0);
    assertThat(worst).isLessThan(30.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6})
  void add_turnsFasterThanAssumed_isFollowed(int seed) {
    turn(2.0, seed, 0, 0, 0.0);

    assertThat(worst).isLessThan(12.0);
    assertThat(worstRate).isLessThan(1.8);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_compassOfWholeDegreesStopsTurning_estimateStopsToo(int seed) {
    turn(1.22, seed, 0, 0, Math.toRadians(1.0));

    assertThat(rmsDeg()).isLessThan(0.8);
    assertThat(worst).isLessThan(13.0);
  }
}
