package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.testkit.ServiceKit;

/** States wait for the inertial sample that is due: others must not make them older than it. */
class InertialPaceTest {
  private static final double INTERVAL_S = 0.025;

  private final ServiceKit kit = new ServiceKit();
  private final List<Double> publishedS = new ArrayList<>();
  private double rateRadps;

  @BeforeEach
  void start() {
    kit.with("DOMAIN", "AIR").with("OUTPUT RATE", 50.0);
    kit.start(FusingStateEstimator::new);
    for (int i = 0; i < 40; i++) { // level, at rest: the first sensor drives the prediction
      kit.advance(INTERVAL_S);
      inertial("IMU 1");
      compass();
    }
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private void inertial(String name) {
    sense(
        new InertialMeasurement()
            .rollRate(0.0)
            .pitchRate(0.0)
            .yawRate(rateRadps)
            .specificForceX(0.0)
            .specificForceY(0.0)
            .specificForceZ(-9.793)
            .sensorName(name));
  }

  private void compass() {
    sense(new StateInformation().sensorName("Compass").psi(0.0).psiSigma(0.5));
  }

  private void sense(StateInformation measured) {
    int before = kit.published(Channels.STATE).size();
    kit.publish(Channels.SENSED_STATE, measured);
    if (kit.published(Channels.STATE).size() > before) {
      publishedS.add(kit.nowS());
    }
  }

  private OptionalDouble turnRate() {
    return kit.latest(Channels.STATE).orElseThrow().psiDot();
  }

  @ParameterizedTest
  @ValueSource(strings = {"IMU 2", "Compass"})
  void state_otherSensorSpeaksFirstAtEachSample_hasTheNewestRates(String other) {
    for (int i = 0; i < 20; i++) {
      kit.advance(INTERVAL_S);
      rateRadps += 0.05;
      if (other.equals("Compass")) {
        compass();
      } else {
        inertial(other);
      }
      inertial("IMU 1");
      assertThat(turnRate().orElseThrow()).isCloseTo(rateRadps, within(0.01));
      assertThat(publishedS.get(publishedS.size() - 1)).isEqualTo(kit.nowS());
    }
  }

  @Test
  void state_inertialSensorFallsSilent_waitsForHalfAStateAtMost() {
    for (int i = 0; i < 100; i++) {
      kit.advance(0.01);
      compass();
    }
    assertThat(publishedS).hasSizeGreaterThan(40);
    for (int i = 1; i < publishedS.size(); i++) {
      assertThat(publishedS.get(i) - publishedS.get(i - 1)).isLessThan(0.0401);
    }
  }

  @Test
  void state_inertialSensorIsSlow_othersGiveStatesInBetween() {
    double begunS = kit.nowS();
    for (int i = 1; i <= 200; i++) {
      kit.advance(0.01);
      if (i % 10 == 0) {
        inertial("IMU 1");
      }
      compass();
    }
    assertThat(publishedS.stream().filter(s -> s > begunS + 1.0).count()).isBetween(40L, 50L);
  }
}
