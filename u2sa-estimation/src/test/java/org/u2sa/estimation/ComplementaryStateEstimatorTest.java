package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** On the way east at 2 m/s: a compass and wheels in time, receivers that need a moment. */
class ComplementaryStateEstimatorTest {
  private static final Geodetic HOME = new Geodetic(-81.0, 29.0, 5.0);
  private static final double SPEED_MPS = 2.0;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private Geodetic place(double seconds) {
    return HOME.fromEnu(Point.of(SPEED_MPS * seconds, 0.0, 0.0));
  }

  private void sense(StateInformation measured) {
    kit.publish(Channels.SENSED_STATE, measured);
  }

  /** A fix that was measured so long ago, so far north of the truth. */
  private void fix(String name, double ageS, double offM) {
    Geodetic at = place(kit.nowS() - ageS).fromEnu(Point.of(0.0, offM, 0.0));
    StateInformation fix =
        new StateInformation().sensorName(name).x(at.longitudeDeg()).y(at.latitudeDeg());
    fix.timestamp(kit.clock().micros() - Clock.micros(ageS));
    sense(fix);
  }

  private void drive(double seconds, Runnable tenthOfASecond) {
    for (int i = 1; i <= seconds * 10; i++) {
      kit.advance(0.1);
      sense(new StateInformation().sensorName("Compass").psi(Math.PI / 2.0).psiSigma(0.02));
      sense(
          new StateInformation()
              .sensorName("Encoders")
              .referenceFrame(ReferenceFrame.BODY)
              .xDot(SPEED_MPS));
      tenthOfASecond.run();
    }
  }

  private StateInformation state() {
    return kit.latest(Channels.STATE).orElseThrow();
  }

  private Point offM() {
    return place(kit.nowS())
        .enuOf(new Geodetic(state().x().orElseThrow(), state().y().orElseThrow(), 5.0));
  }

  @Test
  void callback_fixesOlderThanTheNewestHeading_arePulledAsOfTheirTime() {
    kit.start(ComplementaryStateEstimator::new);
    drive(10.0, () -> fix("GPS", 0.25, 0.0));

    assertThat(offM().x()).isCloseTo(0.0, within(0.05));
    assertThat(offM().y()).isCloseTo(0.0, within(0.01));
    assertThat(state().timestamp()).hasValue(kit.clock().micros());
  }

  @Test
  void start_vehicleThatNeedsRollAndPitch_isRefused() {
    kit.with("NEEDED", "x, y, psi, phi, theta");

    assertThatThrownBy(() -> kit.start(ComplementaryStateEstimator::new))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "variable \"NEEDED\": \"phi\": ComplementaryStateEstimator does not estimate it");
  }

  @Test
  void callback_noHeading_isNamedInHealth() {
    kit.start(ComplementaryStateEstimator::new);
    for (int i = 0; i < 100; i++) {
      kit.advance(0.1);
      fix("GPS", 0.0, 0.0);
    }

    assertThat(kit.log("StateEstimator")).anyMatch(l -> l.contains("state lacks psi"));
  }

  @Test
  void callback_positionsOnly_stateDoesNotLagBehindThem() {
    kit.start(ComplementaryStateEstimator::new);
    for (int i = 0; i < 100; i++) {
      kit.advance(0.1);
      fix("GPS", 0.0, 0.0);
    }

    assertThat(offM().distance()).isLessThan(0.01);
  }

  @Test
  void callback_oneReceiverLateAndOneInTime_bothPull() {
    kit.start(ComplementaryStateEstimator::new);
    drive(
        10.0,
        () -> {
          fix("GPS in time", 0.0, 1.0);
          fix("GPS late", 0.25, -1.0);
        });

    assertThat(offM().y()).isCloseTo(0.0, within(0.1));
  }

  @Test
  void callback_fixesFromTheFuture_areIgnoredAndTheOthersGoOnCounting() {
    kit.start(ComplementaryStateEstimator::new);
    drive(
        10.0,
        () -> {
          fix("GPS", 0.25, 0.0);
          fix("GPS ahead", -3_600.0, 50.0);
        });

    assertThat(offM().x()).isCloseTo(0.0, within(0.05));
    assertThat(state().timestamp()).hasValue(kit.clock().micros());
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValueSatisfying(said -> assertThat(said).contains("GPS ahead", "future"));
  }

  @Test
  void callback_fixOlderThanStaleAfter_isIgnoredAndHealthSaysSo() {
    kit.start(ComplementaryStateEstimator::new);
    drive(1.0, () -> fix("GPS", 3.0, 0.0));

    assertThat(state().x()).isEmpty();
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValueSatisfying(said -> assertThat(said).contains("GPS", "STALE AFTER"));
  }

  @Test
  void callback_wayAcrossTheDateLine_longitudeStaysOnTheEarth() {
    kit.start(ComplementaryStateEstimator::new);
    double degPerS = SPEED_MPS * 360.0 / 40_075_017.0;
    double start = kit.nowS();
    drive(
        10.0,
        () -> {
          double x = 179.9999 + degPerS * (kit.nowS() - start);
          sense(new StateInformation().sensorName("GPS").x(Math.IEEEremainder(x, 360.0)).y(0.0));
        });

    assertThat(state().x().orElseThrow()).isCloseTo(-179.99992, within(1e-5)); // 20 m
  }
}
