package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** One state of what a GPS and a compass measure apart (thesis 4.6.3). */
class SeveralSensorsTest {
  private static final long SECOND = 1_000_000L;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private void start() {
    kit.start(PassThroughStateEstimator::new);
  }

  private void sense(long micros, StateInformation measured) {
    kit.advance(Math.max(0.0, Clock.seconds(micros - kit.clock().micros())));
    measured.timestamp(micros);
    kit.publish(Channels.SENSED_STATE, measured);
  }

  /** On the equator, 2 m/s to the east. */
  private static StateInformation fix() {
    return new StateInformation()
        .sensorName("GPS")
        .x(10.0)
        .y(0.0)
        .xDot(2.0)
        .yDot(0.0)
        .xSigma(3.0)
        .ySigma(3.0);
  }

  private static StateInformation heading(double psi) {
    return new StateInformation().sensorName("Compass").psi(psi).psiSigma(0.02);
  }

  private StateInformation state() {
    return kit.latest(Channels.STATE).orElseThrow();
  }

  private int states() {
    return kit.published(Channels.STATE).size();
  }

  private String lastError() {
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse("");
  }

  @Test
  void callback_gpsAndCompass_areOneStateAtTheNewestTime() {
    start();
    sense(10 * SECOND, fix());
    sense(10 * SECOND + 500_000, heading(1.0));

    assertThat(state().timestamp()).hasValue(10 * SECOND + 500_000);
    assertThat(state().psi()).hasValue(1.0);
    assertThat(state().psiSigma()).hasValue(0.02);
    double aheadM =
        new Geodetic(10.0, 0.0, 0.0)
            .distanceM(new Geodetic(state().x().getAsDouble(), state().y().getAsDouble(), 0.0));
    assertThat(aheadM).as("carried ahead by its velocity").isCloseTo(1.0, within(1e-3));
    // sqrt(3² + (0.1 * 0.5)² + (1 * 0.5² / 2)²): it is no new measurement
    assertThat(state().xSigma().getAsDouble()).isCloseTo(3.00302, within(1e-5));
    assertThat(state().sensorName()).isEqualTo("StateEstimator");
  }

  @Test
  void callback_manyHeadingsAfterAFix_positionGrowsUnsureAndThenDropsOut() {
    kit.with("STALE AFTER", 1.0).with("VELOCITY SIGMA", 0.5);
    start();
    sense(0, fix());
    double before = 0.0;
    for (int i = 1; i <= 10; i++) {
      sense(i * SECOND / 10, heading(1.0));
      assertThat(state().xSigma().getAsDouble()).isGreaterThan(before);
      before = state().xSigma().getAsDouble();
    }
    assertThat(before).isCloseTo(Math.sqrt(9.0 + 0.25 + 0.25), within(1e-9));
    sense(SECOND + 1, heading(1.0));
    assertThat(state().x()).isEmpty();
    assertThat(state().xSigma()).isEmpty();
    assertThat(state().psi()).isPresent();
  }

  @Test
  void callback_positionWithoutVelocity_staysAndGrowsUnsureFaster() {
    start();
    sense(0, new StateInformation().sensorName("GPS").x(10.0).y(0.0).xSigma(3.0).ySigma(3.0));
    sense(SECOND, heading(1.0));

    assertThat(state().x()).hasValue(10.0);
    // sqrt(3² + (1 m/s * 1 s)² + (1 m/s² * 1 s² / 2)²)
    assertThat(state().xSigma().getAsDouble()).isCloseTo(Math.sqrt(10.25), within(1e-9));
  }

  @Test
  void callback_localFrame_isCarriedAlongItsOwnAxes() {
    start();
    sense(
        0,
        new StateInformation()
            .sensorName("beacons")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(1.0)
            .y(2.0)
            .xDot(-3.0)
            .psi(0.1)
            .psiDot(-0.4));
    sense(
        SECOND / 2,
        new StateInformation()
            .sensorName("sonar")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .z(-4.0));

    assertThat(state().x()).hasValue(-0.5);
    assertThat(state().y()).hasValue(2.0);
    assertThat(state().z()).hasValue(-4.0);
    assertThat(state().psi().getAsDouble()).as("0…2π").isCloseTo(2.0 * Math.PI - 0.1, within(1e-9));
  }

  @Test
  void callback_fixThatWasMeasuredBeforeTheLastHeading_countsFromTheNextHeadingOn() {
    start();
    sense(2 * SECOND, heading(1.0));
    int before = states();
    sense(2 * SECOND - 1_000, fix());
    assertThat(states()).as("a state does not go back in time").isEqualTo(before);
    sense(2 * SECOND + 20_000, heading(1.1));
    assertThat(state().x()).isPresent();
    assertThat(state().psi()).hasValue(1.1);
  }

  @Test
  void callback_newMeasurementOfOneSensor_replacesAllThatItSaidBefore() {
    start();
    sense(0, fix().z(5.0).zSigma(1.0));
    sense(SECOND, fix());
    assertThat(state().z()).as("a fix in two dimensions").isEmpty();
    assertThat(state().xSigma()).as("its own").hasValue(3.0);
  }

  @Test
  void callback_twoOfTheSame_theNewestCountsWithItsOwnSigma() {
    start();
    sense(0, fix());
    sense(1, new StateInformation().sensorName("other GPS").x(11.0).y(1.0));
    assertThat(state().x()).hasValue(11.0);
    assertThat(state().xSigma()).as("it said none").isEmpty();
    assertThat(state().xDot()).hasValue(2.0);
  }

  @Test
  void callback_otherFrameOrOtherClock_isNotMixedIn() {
    start();
    sense(0, fix());
    sense(
        1,
        new StateInformation().sensorName("wheels").referenceFrame(ReferenceFrame.BODY).xDot(1.0));
    assertThat(state().x()).as("wheels do not take the fix's place").isPresent();
    assertThat(state().xDot()).hasValue(2.0);
    sense(3600 * SECOND, new StateInformation().sensorName("another clock's").z(1.0));
    sense(100_000, heading(1.0));
    assertThat(state().psi()).as("does not wait for an hour").hasValue(1.0);
    assertThat(state().z()).isEmpty();
  }

  @Test
  void callback_noHeadingForLong_healthSaysWhatLacksAndWhen() {
    start();
    for (int i = 0; i <= 5; i++) {
      sense(i * SECOND, fix());
    }
    kit.advance(1.0);
    assertThat(lastError()).isEmpty();
    sense(5 * SECOND + 1, fix());
    kit.advance(1.0);
    assertThat(lastError())
        .isEqualTo("state lacks psi: no source of heading on sensed-state (received: GPS)");
    assertThat(kit.log("StateEstimator"))
        .filteredOn(line -> line.contains("state lacks"))
        .hasSize(1);
    sense(5 * SECOND + 2, heading(1.0));
    assertThat(kit.log("StateEstimator"))
        .anySatisfy(line -> assertThat(line).contains("state complete again"));
  }

  @Test
  void callback_compassAlone_healthNamesThePosition() {
    start();
    sense(0, heading(1.0));
    sense(6 * SECOND, heading(1.0));
    kit.advance(1.0);
    assertThat(lastError())
        .isEqualTo("state lacks x, y: no source of position on sensed-state (received: Compass)");
  }

  @Test
  void start_neededNumberThatDoesNotExist_isRefused() {
    kit.with("NEEDED", "x, yaw");
    assertThatThrownBy(this::start)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("NEEDED")
        .hasMessageContaining("yaw");
  }

  @Test
  void callback_singleCompleteSensor_isPassedThroughWithNothingAdded() {
    start();
    List<StateInformation> sensed =
        List.of(fix().psi(0.5), fix().psi(0.6).phi(0.1), fix().psi(0.7));
    for (int i = 0; i < sensed.size(); i++) {
      sense(i, sensed.get(i));
      StateInformation expected = sensed.get(i).copy();
      expected.sensorName("StateEstimator");
      expected.systemId(state().systemId());
      assertThat(state()).isEqualTo(expected);
    }
  }
}
