package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** Sensors that somebody invents cost no estimator its memory, and no true sensor its place. */
@Timeout(120)
class InventedSensorsTest {
  static List<Function<ServiceContext, StateEstimator>> estimators() {
    return List.of(
        FusingStateEstimator::new,
        ComplementaryStateEstimator::new,
        PassThroughStateEstimator::new);
  }

  private static StateInformation fix(ServiceKit kit, String sensor, double latitude) {
    StateInformation fix = new StateInformation().sensorName(sensor).x(11.0).y(latitude).z(400.0);
    fix.xSigma(1.0).ySigma(1.0).zSigma(2.0);
    fix.timestamp(Clock.micros(kit.nowS()));
    return fix;
  }

  @ParameterizedTest
  @MethodSource("estimators")
  void estimate_hundredsOfInventedSensors_areIgnoredAndTheTrueOneCounts(
      Function<ServiceContext, StateEstimator> estimator) {
    try (ServiceKit kit = new ServiceKit()) {
      StateEstimator service = kit.start(estimator);
      kit.publish(Channels.SENSED_STATE, fix(kit, "gps", 48.0));
      for (int i = 0; i < 31; i++) {
        kit.publish(Channels.SENSED_STATE, fix(kit, "invented " + i, 48.0));
      }
      kit.advance(1.0);
      kit.forget();
      for (int i = 31; i < 400; i++) {
        kit.publish(Channels.SENSED_STATE, fix(kit, "invented " + i, 20.0));
      }
      assertThat(kit.published(Channels.STATE)).isEmpty();
      kit.publish(Channels.SENSED_STATE, fix(kit, "gps", 48.0));
      kit.advance(0.5);

      assertThat(kit.latest(Channels.STATE).orElseThrow().y().orElseThrow())
          .isCloseTo(48.0, within(1e-6));
      assertThat(service.status()).isEqualTo(ServiceStatus.RUNNING);
      HealthReport report = kit.latest(Channels.HEALTH).orElseThrow();
      assertThat(report.lastError().orElseThrow()).startsWith("more than 32 sensors: ignored ");
    }
  }
}
