package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.fusion.SourceReports.Report;
import org.u2sa.estimation.fusion.SourceReports.Standing;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/** What happens to the estimate when sources fail, lie, come late, or join. */
class RobustnessTest {
  private static final FilterTuning TUNING = Tunings.withoutConstraint(MotionDomain.GROUND);

  private final SimulatedMotion truth = new SimulatedMotion(7);
  private final ErrorStateFilter filter = new ErrorStateFilter(TUNING);
  private final Measurement m = new Measurement();
  private double squares;
  private int samples;

  private void step() {
    truth.wander(0.3, 0.3);
  }

  private void look() {
    if (!filter.at(truth.micros).hasPosition()) {
      return;
    }
    double[] e = truth.errors(filter.at(truth.micros));
    squares += e[0] * e[0] + e[1] * e[1];
    samples++;
  }

  private double rms() {
    return Math.sqrt(squares / samples);
  }

  private Standing standing(String source) {
    for (Report report : filter.sources().at(truth.micros)) {
      if (report.source().equals(source)) {
        return report.standing();
      }
    }
    throw new AssertionError("no source " + source);
  }

  private Measurement shifted(double northM) {
    double before = truth.p[0];
    truth.p[0] += northM;
    truth.fix(m, "Liar", 0.5, 0.2, 1.0);
    truth.p[0] = before;
    return m;
  }

  @Test
  void add_outliers_areGatedAndCounted() {
    Random random = new Random(3);
    for (int i = 1; i <= 6000; i++) {
      step();
      if (i % 20 == 0) {
        truth.fix(m, "GPS", 0.5, 0.2, 1.0);
        if (random.nextInt(10) == 0) {
          truth.fix(m, "GPS", 0.5, 0.2, 200.0);
        }
        filter.add(m);
      }
      filter.add(truth.compass(m, "Compass", 0.03));
      look();
    }
    Report gps = filter.sources().at(truth.micros).get(1);
    assertThat(gps.gated()).isBetween(40L, 120L);
    assertThat(gps.standing()).isEqualTo(Standing.USED);
    assertThat(rms()).isLessThan(0.6);
  }

  @Test
  void add_sourceFallsSilent_positionGrowsUnsureAndComesBack() {
    for (int i = 1; i <= 6000; i++) {
      step();
      boolean isOut = i > 3000 && i < 5000;
      if (i % 20 == 0 && !isOut) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, 1.0));
      }
      filter.add(truth.compass(m, "Compass", 0.03));
      if (i == 2999) {
        assertThat(filter.at(truth.micros).positionSigmaM(0)).isLessThan(0.5);
      }
      if (i == 4999) {
        assertThat(standing("GPS")).isEqualTo(Standing.SILENT);
        assertThat(filter.at(truth.micros).positionSigmaM(0)).isGreaterThan(5.0);
      }
    }
    assertThat(standing("GPS")).isEqualTo(Standing.USED);
    assertThat(Math.abs(truth.errors(filter.at(truth.micros))[0])).isLessThan(1.0);
  }

  @Test
  void add_sourceFreezes_isGatedAndTheOtherCarriesOn() {
    Measurement frozen = new Measurement();
    for (int i = 1; i <= 6000; i++) {
      step();
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, 1.0));
        if (i <= 3000) {
          truth.fix(frozen, "Second", 0.5, 0.2, 1.0);
        } else {
          m.copyFrom(frozen);
          frozen.begin("Second", truth.micros);
          for (int q = 0; q < SensedQuantity.count(); q++) {
            for (int c = 0; c < 3; c++) {
              SensedQuantity quantity = SensedQuantity.at(q);
              if (m.has(quantity, c)) {
                frozen.set(quantity, c, m.value(quantity, c), m.sigma(quantity, c));
              }
            }
          }
        }
        filter.add(frozen);
      }
      filter.add(truth.compass(m, "Compass", 0.03));
      if (i > 3200) {
        look();
      }
    }
    assertThat(standing("Second")).isEqualTo(Standing.FROZEN);
    assertThat(rms()).isLessThan(0.6);
  }

  @Test
  void add_sourceLies_isBiasedAndTheOtherCarriesOn() {
    for (int i = 1; i <= 6000; i++) {
      step();
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, 1.0));
        filter.add(shifted(i > 3000 ? 20.0 : 0.0));
      }
      filter.add(truth.compass(m, "Compass", 0.03));
      look();
    }
    assertThat(standing("Liar")).isEqualTo(Standing.BIASED);
    assertThat(standing("GPS")).isEqualTo(Standing.USED);
    assertThat(rms()).isLessThan(0.6);
  }

  @Test
  void add_onlySourceMovesForGood_positionBeginsAnewThere() {
    for (int i = 1; i <= 4000; i++) {
      step();
      if (i == 2000) {
        truth.p[0] += 50.0; // carried off
      }
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, 1.0));
      }
      filter.add(truth.compass(m, "Compass", 0.03));
    }
    assertThat(filter.resets()).isEqualTo(1);
    assertThat(Math.abs(truth.errors(filter.at(truth.micros))[0])).isLessThan(1.0);
  }

  @Test
  void add_lateAndOutOfOrder_isAsIfInTime() {
    ErrorStateFilter inTime = new ErrorStateFilter(TUNING);
    List<Measurement> waiting = new ArrayList<>();
    for (int i = 1; i <= 3000; i++) {
      step();
      if (i % 20 == 0) {
        Measurement fix = truth.fix(new Measurement(), "GPS", 0.5, 0.2, 1.0);
        inTime.add(fix);
        waiting.add(fix);
      }
      filter.add(truth.compass(m, "Compass", 0.03));
      inTime.add(m);
      while (!waiting.isEmpty() && truth.micros - waiting.get(0).micros() >= 450_000) {
        int which = waiting.size() > 1 && i % 40 == 0 ? 1 : 0; // now and then the younger first
        filter.add(waiting.remove(which));
      }
    }
    waiting.forEach(filter::add);

    Estimate late = filter.at(truth.micros);
    Estimate straight = inTime.at(truth.micros);
    assertThat(filter.late()).isZero();
    assertThat(filter.replayed()).isGreaterThan(100);
    for (int i = 0; i < 2; i++) {
      assertThat(late.velocityMps(i)).isCloseTo(straight.velocityMps(i), within(1e-9));
      assertThat(late.positionSigmaM(i)).isCloseTo(straight.positionSigmaM(i), within(1e-9));
      assertThat(late.localM(i)).isCloseTo(straight.localM(i), within(1e-6));
    }
    assertThat(late.psi()).isCloseTo(straight.psi(), within(1e-9));
  }

  @Test
  void add_olderThanTheHorizon_isDroppedAndCounted() {
    filter.add(truth.compass(m, "Compass", 0.03));
    Measurement old = truth.fix(new Measurement(), "GPS", 0.5, 0.2, 1.0);
    for (int i = 0; i < 150; i++) {
      step();
      filter.add(truth.compass(m, "Compass", 0.03));
    }
    assertThat(filter.add(old)).isEqualTo(ErrorStateFilter.Outcome.TOO_LATE);
    assertThat(filter.late()).isEqualTo(1);
    assertThat(filter.at(truth.micros).hasPosition()).isFalse();
  }

  private static double rmsWith(boolean hasSecond, boolean hasUnknown, boolean hasImu) {
    SimulatedMotion truth = new SimulatedMotion(11);
    ErrorStateFilter filter = new ErrorStateFilter(TUNING);
    Measurement m = new Measurement();
    Random own = new Random(5); // so that the others' noise is the same
    double squares = 0.0;
    for (int i = 1; i <= 12000; i++) {
      truth.wander(0.3, 0.3);
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 1.0, 0.3, 1.0));
      }
      if (i % 10 == 0) {
        filter.add(truth.compass(m, "Compass", 0.05));
      }
      if (hasSecond && i % 20 == 10) {
        SimulatedMotion copy = new SimulatedMotion(own.nextLong());
        copy.micros = truth.micros;
        System.arraycopy(truth.p, 0, copy.p, 0, 3);
        System.arraycopy(truth.v, 0, copy.v, 0, 3);
        filter.add(copy.fix(m, "second receiver", 1.0, 0.3, 1.0));
      }
      if (hasUnknown && i % 5 == 0) {
        m.begin("who knows what", truth.micros);
        m.velocity(
            truth.v[0] + 0.05 * own.nextGaussian(), truth.v[1] + 0.05 * own.nextGaussian(), 0.05);
        filter.add(m);
      }
      if (hasImu && i % 5 == 0) {
        m.begin("IMU", truth.micros);
        m.bodyRates(
            0.01 * own.nextGaussian(),
            0.01 * own.nextGaussian(),
            truth.rate[2] + 0.005 + 0.01 * own.nextGaussian(),
            0.01);
        filter.add(m);
      }
      double[] e = truth.errors(filter.at(truth.micros));
      squares += i > 1000 ? e[0] * e[0] + e[1] * e[1] : 0.0;
    }
    return Math.sqrt(squares / 11000.0);
  }

  @Test
  void add_moreSources_helpAndDoNoHarm() {
    double alone = rmsWith(false, false, false);

    assertThat(rmsWith(true, false, false)).as("second GPS").isLessThan(0.9 * alone);
    assertThat(rmsWith(false, true, false)).as("unknown source").isLessThan(0.9 * alone);
    assertThat(rmsWith(false, false, true)).as("20 Hz IMU").isLessThan(1.02 * alone);
  }

  @Test
  void add_sameMeasurements_giveTheSameBits() {
    long[] bits = new long[2];
    for (int run = 0; run < 2; run++) {
      SimulatedMotion motion = new SimulatedMotion(3);
      ErrorStateFilter each = new ErrorStateFilter(TUNING);
      for (int i = 1; i <= 2000; i++) {
        motion.wander(0.5, 0.5);
        each.add(motion.compass(m, "Compass", 0.03));
        if (i % 20 == 0) {
          each.add(motion.fix(m, "GPS", 0.5, 0.2, 1.0));
        }
      }
      Estimate e = each.at(motion.micros);
      bits[run] =
          Double.doubleToRawLongBits(e.latitudeDeg())
              ^ Double.doubleToRawLongBits(e.psi())
              ^ Double.doubleToRawLongBits(e.positionSigmaM(0));
    }
    assertThat(bits[1]).isEqualTo(bits[0]);
  }
}
