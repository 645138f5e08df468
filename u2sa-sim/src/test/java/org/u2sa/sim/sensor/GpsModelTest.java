package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

class GpsModelTest {
  private static final Geodetic HERE = new Geodetic(-80.42, 37.23, 600.0);
  private static final LocalPlane PLANE = new LocalPlane(HERE);
  private static final VehicleTruth STANDING =
      new VehicleTruth(
          0.0,
          Point.of(0, 0, 0),
          new Attitude(0.0, 0.0, 0),
          Point.of(0, 0, 0),
          Point.ORIGIN,
          Point.ORIGIN);
  private static final double FIVE_SIGMA = 5.0;

  @Test
  void sample_surveyReceiver_scattersAsItSays() {
    GpsParameters white = // no bias: all samples are independent
        new GpsParameters(10.0, 0.0, 0.02, 0.0, 60.0, 1.5, 0.03, 0.0, 1.0, 16, 4);
    GpsModel model = new GpsModel(white, PLANE, new NoiseStreams(5L));
    int n = 20_000;
    double position = 0.0;
    double vertical = 0.0;
    double velocity = 0.0;
    for (int i = 1; i <= n; i++) {
      GpsSample s = model.sample(0.1 * i, STANDING, false);
      Point error = HERE.enuOf(new Geodetic(s.longitudeDeg(), s.latitudeDeg(), 600.0));
      position += square(error.x() / 0.02) + square(error.y() / 0.02);
      vertical += square((s.altitudeM() - 600.0) / 0.03);
      velocity += square(s.eastMps() / 0.03) + square(s.northMps() / 0.03);
    }
    assertChiSquare(position, 2 * n);
    assertChiSquare(vertical, n);
    assertChiSquare(velocity, 2 * n);
  }

  @Test
  void sample_phoneReceiver_isStationaryFromTheBeginningToTheEnd() {
    GpsParameters phone =
        new GpsParameters(1.0, 0.25, 0.5, 3.0, 120.0, 1.5, 0.15, 0.0, 5.0, 9, 1); // no outages
    double variance = square(phone.horizontalSigmaM());
    double first = 0.0;
    double last = 0.0;
    int runs = 2_000;
    for (int run = 0; run < runs; run++) {
      GpsModel model = new GpsModel(phone, PLANE, new NoiseStreams(run));
      first += square(northM(model.sample(1.0, STANDING, false))) / variance;
      last += square(northM(model.sample(600.0, STANDING, false))) / variance;
    }
    assertChiSquare(first, runs);
    assertChiSquare(last, runs);
  }

  @Test
  void sample_blocked_hasNoFixAndLeavesLaterNoiseAsItWas() {
    GpsModel free = new GpsModel(GpsParameters.survey(), PLANE, new NoiseStreams(2L));
    GpsModel blocked = new GpsModel(GpsParameters.survey(), PLANE, new NoiseStreams(2L));
    free.sample(0.1, STANDING, false);
    assertThat(blocked.sample(0.1, STANDING, true).valid()).isFalse();
    assertThat(blocked.sample(0.2, STANDING, false)).isEqualTo(free.sample(0.2, STANDING, false));
  }

  @Test
  void sample_phoneReceiver_dropsOutForItsShareOfTheTime() {
    GpsModel model = new GpsModel(GpsParameters.phone(), PLANE, new NoiseStreams(3L));
    int hours = 200;
    int lost = 0;
    for (int i = 1; i <= hours * 3600; i++) {
      lost += model.sample(i, STANDING, false).valid() ? 0 : 1;
    }
    double expected = hours * 3600.0 * 5.0 / 905.0;
    assertThat((double) lost).isCloseTo(expected, within(0.2 * expected));
  }

  @Test
  void gaussMarkov_longRun_hasTheAllanVarianceOfItsKind() {
    double sigma = 3.0;
    double tau = 20.0;
    int n = 400_000;
    GpsModel.GaussMarkov process =
        new GpsModel.GaussMarkov(sigma, tau, new NoiseStreams(9L).of("test"));
    double[] x = new double[n];
    for (int i = 0; i < n; i++) {
      x[i] = process.step(1.0);
    }
    for (int cluster : new int[] {10, 40, 200}) {
      double t = cluster;
      // IEEE Std 952, C.1.3: exponentially correlated noise
      double expected =
          2.0
              * sigma
              * sigma
              * tau
              / t
              * (1.0
                  - tau / (2.0 * t) * (3.0 - 4.0 * Math.exp(-t / tau) + Math.exp(-2.0 * t / tau)));
      assertThat(allanVariance(x, cluster)).isCloseTo(expected, within(0.1 * expected));
    }
  }

  private static double allanVariance(double[] x, int cluster) {
    int clusters = x.length / cluster;
    double before = 0.0;
    double sum = 0.0;
    for (int k = 0; k < clusters; k++) {
      double mean = 0.0;
      for (int i = 0; i < cluster; i++) {
        mean += x[k * cluster + i] / cluster;
      }
      sum += k == 0 ? 0.0 : square(mean - before);
      before = mean;
    }
    return sum / (2.0 * (clusters - 1));
  }

  private static double northM(GpsSample s) {
    return HERE.enuOf(new Geodetic(s.longitudeDeg(), s.latitudeDeg(), 600.0)).y();
  }

  private static void assertChiSquare(double sum, int n) {
    assertThat(sum).isCloseTo(n, within(FIVE_SIGMA * Math.sqrt(2.0 * n)));
  }

  private static double square(double value) {
    return value * value;
  }
}
