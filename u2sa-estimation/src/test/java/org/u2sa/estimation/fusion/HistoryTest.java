package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;

/** Whatever comes late is fused where it belongs, as if it had come in time. */
class HistoryTest {
  private static final FilterTuning TUNING = FilterTuning.of(MotionDomain.GROUND);
  private static final long EVERY_MICROS = 5_000;
  private static final int COUNT = 2_000;

  private record Arrival(long micros, Measurement measurement) {}

  /** A measurement of one of three sources, each 5 ms after the one before. */
  private static Measurement measurement(int number, Random random) {
    Measurement m = new Measurement();
    switch (number % 3) {
      case 0:
        m.begin("imu", (number + 1) * EVERY_MICROS);
        m.bodyRates(0.0, 0.0, 0.1 + 0.01 * random.nextGaussian(), 0.01);
        m.specificForce(0.1 * random.nextGaussian(), 0.1 * random.nextGaussian(), -9.8, 0.1);
        break;
      case 1:
        m.begin("gps", (number + 1) * EVERY_MICROS);
        m.localPlace(0.01 * number + random.nextGaussian(), random.nextGaussian(), 1.0);
        break;
      default:
        m.begin("compass", (number + 1) * EVERY_MICROS);
        m.heading(0.0005 * number + 0.01 * random.nextGaussian(), 0.01);
        break;
    }
    return m;
  }

  private static List<Measurement> inOrderOfArrival(Random random, double latestS) {
    List<Arrival> arrivals = new ArrayList<>();
    for (int i = 0; i < COUNT; i++) {
      double lateS = random.nextInt(4) > 0 ? 0.03 : latestS; // most by a few, some by many
      long micros = (i + 1) * EVERY_MICROS + (long) (lateS * 1e6 * random.nextDouble());
      arrivals.add(new Arrival(micros, measurement(i, random)));
    }
    arrivals.sort(Comparator.comparingLong(Arrival::micros));
    return arrivals.stream().map(Arrival::measurement).toList();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void state_askedAfterEachOfManyThatComeLate_isAsIfTheyHadComeInOrder(long seed) {
    List<Measurement> arrivals = inOrderOfArrival(new Random(seed), 0.9 * TUNING.horizonS());
    ErrorStateFilter late = new ErrorStateFilter(TUNING);
    ErrorStateFilter inTime = new ErrorStateFilter(TUNING);
    // Both know the sources in the same order, so that their numbers stand in the same places.
    for (int i = 0; i < 3; i++) {
      Measurement first = measurement(i, new Random(0));
      late.add(first);
      inTime.add(first);
    }
    late.state();
    inTime.state();
    for (Measurement m : arrivals) {
      assertThat(late.add(m)).isNotEqualTo(ErrorStateFilter.Outcome.TOO_LATE);
      late.state();
    }
    arrivals.stream()
        .sorted(Comparator.comparingLong(Measurement::micros))
        .forEach(
            m -> {
              inTime.add(m);
              inTime.state();
            });

    assertThat(late.replayed()).isGreaterThan(COUNT / 4);
    assertThat(late.state().x).isEqualTo(inTime.state().x);
    assertThat(late.state().p.data).isEqualTo(inTime.state().p.data);
    assertThat(late.state().trust).isEqualTo(inTime.state().trust);
  }
}
