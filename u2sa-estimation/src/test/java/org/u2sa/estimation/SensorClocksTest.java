package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

/** A sensor whose host has another time: its clock must not lead the estimate into the future. */
class SensorClocksTest {
  private final ServiceKit kit = new ServiceKit();
  private long statesAhead; // later than the estimator's own time

  @AfterEach
  void close() {
    kit.close();
  }

  private void sense(String name, double aheadS) {
    StateInformation sensed =
        new StateInformation()
            .sensorName(name)
            .x(10.0)
            .y(54.0)
            .psi(1.0)
            .xSigma(0.5)
            .ySigma(0.5)
            .psiSigma(0.02);
    sensed.timestamp(kit.clock().micros() + Math.round(aheadS * 1e6));
    kit.publish(Channels.SENSED_STATE, sensed);
  }

  private void run(double aheadS) {
    for (int i = 0; i < 200; i++) {
      kit.advance(0.05);
      sense("Compass and GPS", 0.0);
      if (i % 4 == 0) {
        sense("Other host", aheadS);
      }
      long stamp = kit.latest(Channels.STATE).orElseThrow().timestamp().orElseThrow();
      statesAhead += stamp > kit.clock().micros() ? 1 : 0;
    }
  }

  private long linesAbout(String words) {
    return kit.published(Channels.HEALTH).stream()
        .flatMap(report -> report.lastError().stream())
        .distinct()
        .filter(line -> line.contains(words))
        .count();
  }

  static Stream<Named<Function<ServiceContext, U2SAService>>> estimators() {
    return Stream.of(
        Named.of("fusing", FusingStateEstimator::new),
        Named.of("complementary", ComplementaryStateEstimator::new),
        Named.of("pass-through", PassThroughStateEstimator::new));
  }

  @ParameterizedTest
  @MethodSource("estimators")
  void onMeasurement_clockAheadByHalfASecond_countsAsMadeOnArrival(
      Function<ServiceContext, U2SAService> estimator) {
    kit.start(estimator::apply);
    run(0.4);

    assertThat(statesAhead).isZero();
    assertThat(linesAbout("the clock of Other host is 0.40 s ahead")).isEqualTo(1);
  }

  @Test
  void onMeasurement_clockAheadByMilliseconds_isNotWorthALine() {
    kit.start(FusingStateEstimator::new);
    run(0.02);

    assertThat(statesAhead).isZero();
    assertThat(linesAbout("ahead")).isZero();
  }

  @Test
  void state_clockAhead_comesAsOftenAsWithoutIt() {
    kit.with("OUTPUT RATE", 20.0).start(FusingStateEstimator::new);
    run(0.4);

    assertThat(kit.published(Channels.STATE).size()).isBetween(195, 200);
  }
}
