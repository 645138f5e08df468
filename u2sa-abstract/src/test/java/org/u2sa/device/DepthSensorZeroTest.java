package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.Pressure;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** A gauge that reads 5 kPa too much, half a metre of water. */
class DepthSensorZeroTest {
  private static final double OFF_PA = 5_000.0;
  private static final double AIR_PA = 101_325.0;
  private static final double PA_PER_M = 1_025.0 * 9.80665;

  @AutoClose private final ServiceKit kit = new ServiceKit();
  private double depthM;

  private List<StateInformation> depths() {
    return kit.published(Channels.SENSED_STATE);
  }

  private double newestZ() {
    return depths().get(depths().size() - 1).z().orElseThrow();
  }

  private DepthSensor start() {
    kit.with("ZERO TIME", 1.0).with("FLOATING DEPTH", 0.12);
    return kit.start(this::sensor);
  }

  private DepthSensor sensor(ServiceContext context) {
    return new DepthSensor(
        context,
        now ->
            Optional.of(
                new Pressure(now, AIR_PA + OFF_PA + depthM * PA_PER_M, OptionalDouble.empty())));
  }

  @Test
  void step_afloatAtTheStart_laterDepthsLackTheGaugesError() {
    depthM = 0.12;
    start();
    kit.advance(0.9);
    assertThat(depths()).as("none before the error is known").isEmpty();
    kit.advance(0.3);
    depthM = 4.0;
    kit.advance(0.1);

    assertThat(newestZ()).isCloseTo(-4.0, within(1e-6));
  }

  @Test
  void step_restartedUnderWater_keepsTheErrorLearntAfloat() {
    depthM = 0.12;
    DepthSensor sensor = start();
    kit.advance(2.0);
    depthM = 0.6; // less than MAX ERROR
    kit.restart(sensor, this::sensor);
    kit.advance(0.1);

    assertThat(newestZ()).isCloseTo(-0.6, within(1e-6));
  }

  @Test
  void step_startedUnderWater_isNotCorrectedAndSaysSo() {
    depthM = 4.0;
    start();
    kit.advance(0.1);

    assertThat(newestZ()).isCloseTo(-4.0 - OFF_PA / PA_PER_M, within(1e-6));
    assertThat(kit.log("DepthSensor")).anyMatch(line -> line.contains("not afloat"));
  }
}
