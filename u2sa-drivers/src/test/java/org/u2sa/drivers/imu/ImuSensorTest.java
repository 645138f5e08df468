package org.u2sa.drivers.imu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.ImuSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

class ImuSensorTest {
  private static final double TINY = 1e-9;
  private static final String LINE =
      "VNYMR,+090.000,-010.000,+020.000,0,0,0,1.7,-3.3,-9.1,0.1,0.2,0.3";

  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @BeforeEach
  void start() {
    kit.start(context -> new ImuSensor(context, new VectorNav(link)));
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private StateInformation state() {
    link.fromDevice(Nmea.bytes(LINE));
    kit.advance(0.1);
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  @Test
  void step_attitude_isPublishedInGlobal() {
    StateInformation state = state();

    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(state.phi().orElseThrow()).isCloseTo(Math.toRadians(20.0), within(TINY));
    assertThat(state.theta().orElseThrow()).isCloseTo(Math.toRadians(-10.0), within(TINY));
    assertThat(state.phiSigma()).isPresent();
    assertThat(state.phiDot().orElseThrow())
        .isCloseTo(
            0.1 + Math.sin(state.theta().getAsDouble()) * state.psiDot().getAsDouble(),
            within(TINY));
    assertThat(state.thetaDot()).isPresent();
    assertThat(state.psi()).as("true north is not known yet").isEmpty();
  }

  private InertialMeasurement inertial() {
    return kit.published(Channels.SENSED_STATE).stream()
        .filter(InertialMeasurement.class::isInstance)
        .map(InertialMeasurement.class::cast)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void step_ratesAndForces_arePublishedAsTheyAreUnderANameOfTheirOwn() {
    StateInformation attitude = state();
    InertialMeasurement inertial = inertial();
    assertThat(inertial.referenceFrame()).isEqualTo(ReferenceFrame.BODY_FRD);
    assertThat(inertial.sensorName()).isEqualTo("ImuSensor inertial");
    assertThat(inertial.rollRate()).hasValue(0.1);
    assertThat(inertial.pitchRate()).hasValue(0.2);
    assertThat(inertial.yawRate()).hasValue(0.3);
    assertThat(inertial.specificForceX()).hasValue(1.7);
    assertThat(inertial.specificForceY()).hasValue(-3.3);
    assertThat(inertial.specificForceZ()).hasValue(-9.1);
    assertThat(inertial.angularRateSigma()).hasValue(0.005);
    assertThat(inertial.specificForceSigma()).hasValue(0.1);
    assertThat(inertial.timestamp()).isEqualTo(attitude.timestamp());
    assertThat(attitude).as("the last one").isNotInstanceOf(InertialMeasurement.class);
  }

  @Test
  void step_inertialNotWanted_attitudeOnly() {
    kit.with("PUBLISH INERTIAL", false).with("SERVICE NAME", "Other");
    MemoryLink other = new MemoryLink();
    kit.start(context -> new ImuSensor(context, new VectorNav(other)));
    other.fromDevice(Nmea.bytes(LINE));
    kit.advance(0.1);
    assertThat(kit.published(Channels.SENSED_STATE))
        .hasSize(1)
        .noneMatch(InertialMeasurement.class::isInstance);
  }

  @Test
  void step_positionKnown_headingIsTrue() {
    kit.publish(
        Channels.STATE,
        new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).x(-80.42336).y(37.22957));

    assertThat(Math.toDegrees(state().psi().orElseThrow())).isBetween(80.0, 83.0);
  }
}
