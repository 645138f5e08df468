package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A receiver and a compass whose errors wander slowly, on a vehicle that stands. */
class PersistentErrorsTest {
  private static final Geodetic PLACE = new Geodetic(-81.0, 29.0, 0.0);
  private static final double CLAIM_M = 3.0;
  private static final double CLAIM_RAD = 0.02;

  private final Measurement m = new Measurement();
  private final Random random = new Random(5);
  private long micros = 1_000_000;
  private Point offM = Point.of(2.5, -2.0, 0.0); // the receiver's error: east, north

  private void second(ErrorStateFilter filter) {
    Geodetic seen =
        PLACE.fromEnu(
            offM.plus(Point.of(0.5 * random.nextGaussian(), 0.5 * random.nextGaussian(), 0.0)));
    filter.add(
        m.begin("GPS", micros).place(seen.latitudeDeg(), seen.longitudeDeg(), CLAIM_M, CLAIM_M));
    for (int i = 0; i < 10; i++) {
      filter.add(
          m.begin("Compass", micros)
              .heading(1.0 + 0.2 * CLAIM_RAD * random.nextGaussian(), CLAIM_RAD));
      filter.add(m.begin("Encoders", micros).forward(0.0, 0.02).turnRate(0.0, 0.001));
      micros += 100_000;
    }
  }

  private void mark(ErrorStateFilter filter) {
    filter.add(m.begin("start", micros).place(PLACE.latitudeDeg(), PLACE.longitudeDeg(), 0.1, 0.1));
  }

  private double errorM(ErrorStateFilter filter) {
    Estimate e = filter.at(filter.micros());
    Point apart = PLACE.enuOf(new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0));
    return Math.hypot(apart.x(), apart.y());
  }

  @Test
  void add_sameErrorForAMinute_sigmaStaysAboutTheClaim() {
    ErrorStateFilter filter = new ErrorStateFilter(Tunings.persistent(120.0, 60.0));
    ErrorStateFilter naive = new ErrorStateFilter(Tunings.persistent(0.0, 0.0));
    for (int i = 0; i < 60; i++) {
      long from = micros;
      second(filter);
      micros = from;
      second(naive);
    }
    Estimate e = filter.at(filter.micros());
    assertThat(e.positionSigmaM(0)).isBetween(0.85 * CLAIM_M, 1.05 * CLAIM_M);
    assertThat(e.positionSigmaM(1)).isBetween(0.85 * CLAIM_M, 1.05 * CLAIM_M);
    assertThat(e.attitudeSigma(2)).isBetween(0.7 * CLAIM_RAD, 1.05 * CLAIM_RAD);
    Estimate without = naive.at(naive.micros());
    assertThat(without.positionSigmaM(0)).isLessThan(0.4 * CLAIM_M);
    assertThat(without.attitudeSigma(2)).isLessThan(0.65 * CLAIM_RAD);
  }

  @Test
  void add_startKnown_receiversErrorDoesNotDrawItAway() {
    ErrorStateFilter filter = new ErrorStateFilter(Tunings.persistent(120.0, 60.0));
    second(filter);
    assertThat(errorM(filter)).isGreaterThan(2.0);
    mark(filter);
    for (int i = 0; i < 60; i++) {
      offM = offM.plus(Point.of(-0.03, 0.05, 0.0)); // the error wanders
      second(filter);
    }
    assertThat(errorM(filter)).isLessThan(0.6);
    assertThat(filter.at(micros).positionSigmaM(0)).isBetween(0.1, 1.5);
  }

  @Test
  void read_persistentErrors_goesOnAsTheFilterBefore() {
    FilterTuning tuning = Tunings.persistent(120.0, 60.0);
    ErrorStateFilter filter = new ErrorStateFilter(tuning);
    second(filter);
    mark(filter);
    for (int i = 0; i < 20; i++) {
      second(filter);
    }
    Map<String, String> texts = new HashMap<>();
    FilterMemory.write(filter, texts::put);
    ErrorStateFilter next = new ErrorStateFilter(tuning);
    next.trust().source("another"); // sources are numbered again
    assertThat(FilterMemory.read(next, name -> Optional.ofNullable(texts.get(name)))).isTrue();
    for (int i = 0; i < 20; i++) {
      second(next);
    }
    assertThat(errorM(next)).isLessThan(0.6);
    assertThat(next.at(micros).positionSigmaM(0)).isBetween(0.1, 1.0);
  }

  @Test
  void add_fourReceivers_noneMakesTheFilterSurerThanItsErrorsAllow() {
    ErrorStateFilter filter = new ErrorStateFilter(Tunings.persistent(120.0, 60.0));
    for (int i = 0; i < 30; i++) {
      for (int k = 0; k < 4; k++) {
        filter.add(
            m.begin("GPS " + k, micros)
                .place(PLACE.latitudeDeg(), PLACE.longitudeDeg(), CLAIM_M, CLAIM_M));
        micros += 250_000;
      }
    }
    assertThat(filter.at(micros).positionSigmaM(0))
        .isCloseTo(CLAIM_M / Math.sqrt(4.0), within(0.35 * CLAIM_M));
  }
}
