package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.mult.VectorVectorMult_DDRM;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Whether the errors are as large as the filter says, over many seeded runs: the normalised squared
 * error of state and innovation must lie within the 95 % bounds of its χ² distribution (Bar-Shalom,
 * Li, Kirubarajan 2001, section 5.4).
 */
class ConsistencyTest {
  private static final int[] OBSERVED = {0, 1, 3, 4, 8};

  private record Outcome(double nees, double nis, double headingNees) {}

  private interface Run {
    Outcome of(long seed);
  }

  private static Outcome outcome(ErrorStateFilter filter, SimulatedMotion truth) {
    Estimate e = filter.at(truth.micros);
    double[] errors = truth.errors(e);
    DMatrixRMaj p = new DMatrixRMaj(4, 4);
    for (int i = 0; i < 4; i++) {
      for (int k = 0; k < 4; k++) {
        p.set(i, k, e.covariance(OBSERVED[i], OBSERVED[k]));
      }
    }
    DMatrixRMaj error = new DMatrixRMaj(4, 1, true, errors[0], errors[1], errors[2], errors[3]);
    DMatrixRMaj inverse = new DMatrixRMaj(4, 4);
    assertThat(CommonOps_DDRM.invert(p, inverse)).isTrue();
    double nees = VectorVectorMult_DDRM.innerProdA(error, inverse, error);
    FilterState s = filter.state();
    SourceTrust trust = filter.trust();
    int at = trust.of(s, trust.source("GPS"), SensedQuantity.PLACE);
    double heading = errors[4] * errors[4] / (e.attitudeSigma(2) * e.attitudeSigma(2));
    return new Outcome(nees, s.trust[at + SourceTrust.NIS], heading);
  }

  private static Outcome planar(long seed, double lies) {
    FilterTuning tuning = Tunings.withoutConstraint(MotionDomain.GROUND);
    SimulatedMotion truth = new SimulatedMotion(seed);
    ErrorStateFilter filter = new ErrorStateFilter(tuning);
    Measurement m = new Measurement();
    for (int i = 1; i <= 6000; i++) {
      truth.wander(tuning.accelerationNoise(), tuning.turnSigma());
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, lies));
      }
      if (i % 10 == 0) {
        filter.add(truth.compass(m, "Compass", 0.03));
      }
    }
    return outcome(filter, truth);
  }

  private static Outcome strapdown(long seed, double lies) {
    FilterTuning tuning = Tunings.withoutConstraint(MotionDomain.AIR);
    SimulatedMotion truth = new SimulatedMotion(seed);
    double[] bias = truth.biases(tuning.gyroBiasSigma() / 2, tuning.forceBiasSigma());
    ErrorStateFilter filter = new ErrorStateFilter(tuning);
    Measurement m = new Measurement();
    for (int i = 1; i <= 6000; i++) {
      truth.fly(i < 200 ? 0.0 : 1.0, i < 200 ? 0.0 : 0.2);
      filter.add(truth.imu(m, "IMU", bias, 0.01, 0.2));
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, lies));
      }
      if (i % 10 == 0) {
        filter.add(truth.compass(m, "Compass", 0.03));
      }
    }
    return outcome(filter, truth);
  }

  private static void assertConsistent(String name, int runs, Run run) throws IOException {
    double nees = 0.0;
    double nis = 0.0;
    double heading = 0.0;
    for (int seed = 1; seed <= runs; seed++) {
      Outcome outcome = run.of(seed);
      nees += outcome.nees() / runs;
      nis += outcome.nis() / runs;
      heading += outcome.headingNees() / runs;
    }
    report(name, runs, nees, heading, nis);
    assertThat(nees)
        .as("NEES")
        .isBetween(bound(4 * runs, -1.96) / runs, bound(4 * runs, 1.96) / runs);
    assertThat(heading)
        .as("heading")
        .isBetween(bound(runs, -1.96) / runs, bound(runs, 1.96) / runs);
    assertThat(nis)
        .as("NIS")
        .isBetween(bound(2 * runs, -1.96) / runs, bound(2 * runs, 1.96) / runs);
  }

  /** A row of the table in docs/state-estimation.md, into {@code target/} of the module. */
  private static void report(String name, int runs, double nees, double heading, double nis)
      throws IOException {
    Path folder = Files.createDirectories(Path.of("target"));
    Files.writeString(
        folder.resolve("filter-consistency.txt"),
        String.format(
            Locale.ROOT, "| %s, %d runs | %.2f | %.2f | %.2f |%n", name, runs, nees, heading, nis),
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }

  private static double bound(int degrees, double z) {
    return Fuser.threshold(degrees, z);
  }

  @Test
  void estimate_gpsAndCompass_errorsAreAsItSays() throws IOException {
    assertConsistent("GPS and compass, on the ground", 20, seed -> planar(seed, 1.0));
  }

  @Test
  void estimate_receiverThreeTimesWorseThanItsClaim_errorsAreAsItSays() throws IOException {
    assertConsistent(
        "on the ground, GPS errs by three times its claim", 20, seed -> planar(seed, 3.0));
  }

  @Test
  void estimate_inertialSensorGpsAndCompass_errorsAreAsItSays() throws IOException {
    assertConsistent("IMU, GPS and compass, in the air", 20, seed -> strapdown(seed, 1.0));
  }

  @Test
  @Tag("long")
  void estimate_hundredRunsOfEach_errorsAreAsItSays() throws IOException {
    assertConsistent("GPS and compass, on the ground", 100, seed -> planar(seed, 1.0));
    assertConsistent("IMU, GPS and compass, in the air", 100, seed -> strapdown(seed, 1.0));
  }

  @Test
  @Tag("long")
  void estimate_hundredRunsWithAReceiverThreeTimesWorse_errorsAreAsItSays() throws IOException {
    assertConsistent(
        "on the ground, GPS errs by three times its claim", 100, seed -> planar(seed, 3.0));
    assertConsistent(
        "in the air, GPS errs by three times its claim", 100, seed -> strapdown(seed, 3.0));
  }
}
