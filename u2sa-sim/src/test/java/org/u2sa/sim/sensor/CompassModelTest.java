package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

class CompassModelTest {
  private static final double DECLINATION = -0.15;
  private static final NoiseStreams STREAMS = new NoiseStreams(4L);

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 0.1, 1.6, 3.2, 6.2})
  void sample_perfectCompass_givesMagneticHeading(double heading) {
    CompassModel model = new CompassModel(CompassParameters.perfect(DECLINATION), STREAMS);
    double magnetic = model.sample(facing(heading), CompassModel.Disturbance.none());
    double error = Math.IEEEremainder(magnetic + DECLINATION - heading, 2.0 * Math.PI);
    assertThat(error).isCloseTo(0.0, within(1e-12));
    assertThat(magnetic).isBetween(0.0, 2.0 * Math.PI);
  }

  @Test
  void sample_hardIronAhead_errsAsTheTextbookSays() {
    CompassParameters hard = new CompassParameters(20, 0, 20.0, 1.0, 0, 0, 0, 0, 0, 0, 0);
    CompassModel model = new CompassModel(hard, STREAMS);
    // one cycle: B sin(heading), B the iron's field by the earth's
    double east = model.sample(facing(Math.PI / 2.0), CompassModel.Disturbance.none());
    assertThat(east - Math.PI / 2.0).isCloseTo(-Math.atan(1.0 / 20.0), within(1e-12));
    assertThat(model.sample(facing(0.0), CompassModel.Disturbance.none()))
        .isCloseTo(0.0, within(1e-12));
  }

  @Test
  void sample_softIron_errsTwiceATurn() {
    CompassParameters soft = new CompassParameters(20, 0, 20.0, 0, 0, 0.1, 0, 0, 0, 0, 0);
    CompassModel model = new CompassModel(soft, STREAMS);
    double first =
        model.sample(facing(Math.PI / 4.0), CompassModel.Disturbance.none()) - Math.PI / 4.0;
    double second =
        model.sample(facing(Math.PI * 5.0 / 4.0), CompassModel.Disturbance.none())
            - Math.PI * 5.0 / 4.0;
    assertThat(first).isNegative().isCloseTo(second, within(1e-12));
  }

  @Test
  void sample_motorCurrent_disturbs() {
    CompassModel model = new CompassModel(CompassParameters.phone(0.0), STREAMS);
    CompassModel again = new CompassModel(CompassParameters.phone(0.0), new NoiseStreams(4L));
    double quiet = model.sample(facing(1.0), CompassModel.Disturbance.none());
    assertThat(again.sample(facing(1.0), new CompassModel.Disturbance(0, 0, 20, -20)))
        .isNotEqualTo(quiet);
  }

  @Test
  void sample_calibratedCompass_scattersByThreeTenthsOfADegree() {
    CompassParameters noisy =
        new CompassParameters(20, 0, 21.0, 0, 0, 0, 0, 0, 0, 0, 0.1); // calibrated(), noise alone
    CompassModel model = new CompassModel(noisy, STREAMS);
    int n = 20_000;
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
      double error = model.sample(facing(2.0), CompassModel.Disturbance.none()) - 2.0;
      sum += error * error;
    }
    double sigma = 0.1 / 21.0; // across the field [rad]
    assertThat(sum / (sigma * sigma)).isCloseTo(n, within(5.0 * Math.sqrt(2.0 * n)));
    assertThat(Math.toDegrees(sigma)).isCloseTo(0.3, within(0.05));
  }

  private static VehicleTruth facing(double headingRad) {
    return new VehicleTruth(
        0.0,
        Point.of(0, 0, 0),
        new Attitude(0.0, 0.0, headingRad),
        Point.of(0, 0, 0),
        Point.ORIGIN,
        Point.ORIGIN);
  }
}
