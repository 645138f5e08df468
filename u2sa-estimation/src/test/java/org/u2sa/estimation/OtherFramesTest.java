package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** What the estimator that passes on does with measurements along the vehicle's own axes. */
class OtherFramesTest {
  private final ServiceKit kit = new ServiceKit();

  @BeforeEach
  void begin() {
    kit.start(PassThroughStateEstimator::new);
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private void wheels() {
    kit.publish(
        Channels.SENSED_STATE,
        new StateInformation().sensorName("wheels").referenceFrame(ReferenceFrame.BODY).xDot(1.0));
  }

  private void gps() {
    kit.publish(
        Channels.SENSED_STATE, new StateInformation().sensorName("gps").x(8.0).y(50.0).psi(1.0));
  }

  @Test
  void estimate_wheelsBesideGps_doNotTakeThePositionsPlace() {
    gps();
    kit.advance(0.1);
    wheels();
    assertThat(kit.published(Channels.STATE)).hasSize(1);
    assertThat(kit.latest(Channels.STATE).orElseThrow().x()).isPresent();
  }

  @Test
  void estimate_wheelsAlone_arePassedOn() {
    wheels();
    assertThat(kit.latest(Channels.STATE).orElseThrow().xDot()).hasValue(1.0);
  }

  @Test
  void estimate_gpsGone_wheelsArePassedOnAgain() {
    gps();
    kit.advance(3.0);
    wheels();
    assertThat(kit.latest(Channels.STATE).orElseThrow().xDot()).hasValue(1.0);
  }

  @Test
  void estimate_inertialMeasurementBesideGps_isNoState() {
    gps();
    InertialMeasurement inertial = new InertialMeasurement().yawRate(0.1);
    inertial.sensorName("IMU inertial");
    kit.publish(Channels.SENSED_STATE, inertial);
    assertThat(kit.published(Channels.STATE)).hasSize(1);
  }

  @Test
  void estimate_plainSensorBesideARicherOne_keepsWhatOnlyThatSays() {
    AircraftState aircraft = new AircraftState().weightOnWheels(true).engineRpm(900.0);
    aircraft.sensorName("aircraft").x(8.0).y(50.0).z(7.0).zSigma(0.5);
    kit.publish(Channels.SENSED_STATE, aircraft);
    kit.advance(0.05);
    kit.publish(Channels.SENSED_STATE, new StateInformation().sensorName("barometer").z(9.0));
    assertThat(kit.latest(Channels.STATE).orElseThrow())
        .isInstanceOfSatisfying(
            AircraftState.class,
            state -> {
              assertThat(state.weightOnWheels()).isTrue();
              assertThat(state.engineRpm()).hasValue(900.0);
              assertThat(state.z()).hasValue(9.0);
              assertThat(state.zSigma()).as("it said none").isEmpty();
              assertThat(state.x().orElseThrow()).isCloseTo(8.0, within(1e-9));
              assertThat(state.timestamp()).hasValue(50_000L);
            });
  }
}
