package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

/**
 * A submarine on its way north with its nose up, and slowly up and down; its receiver has had fixes
 * at the surface only.
 */
class UnderWaterTest {
  private static final Geodetic HOME = new Geodetic(10.0, 54.0, -2.0);
  private static final double G_MPS2 = 9.8148; // there
  private static final double WAVE_RAD_PER_S = 1.0;

  private final ServiceKit kit = new ServiceKit();
  private double pitchRad = Math.toRadians(25.0);
  private double northMps = 0.4;
  private double waveM;
  private double northM;
  private boolean hasInertial;
  private boolean hasTilt;
  private boolean hasVelocityLog = true;

  @AfterEach
  void close() {
    kit.close();
  }

  private void sense(StateInformation measured) {
    kit.publish(Channels.SENSED_STATE, measured);
  }

  private StateInformation state() {
    return kit.latest(Channels.STATE).orElseThrow();
  }

  private double upMps() {
    return waveM * WAVE_RAD_PER_S * Math.cos(WAVE_RAD_PER_S * kit.nowS());
  }

  private double altitudeM() {
    return HOME.altitudeM() + waveM * Math.sin(WAVE_RAD_PER_S * kit.nowS());
  }

  private Point along(Point ned) {
    return new Attitude(0.0, pitchRad, 0.0).nedFromFrd().transposed().times(ned);
  }

  private void surface() {
    sense(
        new StateInformation()
            .sensorName("GPS")
            .x(HOME.longitudeDeg())
            .y(HOME.latitudeDeg())
            .xSigma(0.1)
            .ySigma(0.1));
  }

  private void dive(double seconds) {
    for (int i = 1; i <= seconds * 20; i++) {
      kit.advance(0.05);
      northM += 0.05 * northMps;
      sense(new StateInformation().sensorName("Compass").psi(0.0).psiSigma(0.02));
      sense(new StateInformation().sensorName("Depth").z(altitudeM()).zSigma(0.1));
      if (hasInertial) {
        senseForce();
      }
      if (hasTilt) {
        sense(
            new StateInformation()
                .sensorName("AHRS")
                .phi(0.0)
                .phiSigma(0.01)
                .theta(pitchRad)
                .thetaSigma(0.01));
      }
      if (hasVelocityLog) {
        Point speeds = along(Point.of(northMps, 0.0, -upMps()));
        sense(
            new StateInformation()
                .sensorName("DVL")
                .referenceFrame(ReferenceFrame.BODY_FRD)
                .xDot(speeds.x())
                .yDot(speeds.y())
                .zDot(speeds.z())
                .xDotSigma(0.01)
                .yDotSigma(0.01)
                .zDotSigma(0.01));
      }
    }
  }

  private void senseForce() {
    double upMps2 = -waveM * WAVE_RAD_PER_S * WAVE_RAD_PER_S * Math.sin(kit.nowS());
    Point force = along(Point.of(0.0, 0.0, -upMps2 - G_MPS2));
    InertialMeasurement imu = new InertialMeasurement().rollRate(0.0).pitchRate(0.0).yawRate(0.0);
    imu.specificForceX(force.x()).specificForceY(force.y()).specificForceZ(force.z());
    sense(imu.sensorName("IMU"));
  }

  private double offM() {
    Geodetic at = new Geodetic(state().x().orElseThrow(), state().y().orElseThrow(), -2.0);
    Point ned = HOME.nedOf(at);
    return Math.hypot(ned.x() - northM, ned.y());
  }

  @Test
  void estimate_unmeasuredPitchUnderWay_depthAndPositionStayWithinTheirSigmas() {
    kit.with("DOMAIN", "UNDERWATER").start(FusingStateEstimator::new);
    surface();
    dive(40.0);

    assertThat(state().theta()).isEmpty();
    assertThat(state().z().orElseThrow()).isCloseTo(-2.0, within(0.2));
    assertThat(offM()).isLessThan(3.0 * state().ySigma().orElseThrow()).isLessThan(1.0);
  }

  @Test
  void estimate_velocityLogSilent_depthAndItsRateAreStillFollowed() {
    pitchRad = 0.0;
    hasInertial = true;
    kit.with("DOMAIN", "UNDERWATER").with("POSITION CORRELATION", 120.0);
    kit.start(FusingStateEstimator::new);
    surface();
    dive(20.0);
    hasVelocityLog = false;
    northMps = 0.0;
    waveM = 0.5;
    for (int i = 0; i < 20; i++) {
      dive(1.5);
      if (i > 10) {
        assertThat(state().z().orElseThrow()).isCloseTo(altitudeM(), within(0.2));
        assertThat(state().zDot().orElseThrow()).isCloseTo(upMps(), within(0.1));
      }
    }
  }

  @Test
  void estimate_complementaryWithoutVerticalSpeed_derivesItFromTheDepth() {
    hasVelocityLog = false;
    kit.start(ComplementaryStateEstimator::new);
    dive(5.0);
    assertThat(state().zDot().orElseThrow()).isCloseTo(0.0, within(1e-6));

    waveM = 0.3;
    dive(2.0 * Math.PI);
    assertThat(state().zDot().orElseThrow()).isCloseTo(upMps(), within(0.15));
    assertThat(state().zDotSigma().orElseThrow()).isGreaterThan(0.15);
  }

  @Test
  void estimate_complementaryWithVelocityLogAndTilt_carriesThePositionOnAndSaysHowWell() {
    hasTilt = true;
    kit.start(ComplementaryStateEstimator::new);
    dive(0.1);
    surface();
    northM = 0.0;
    dive(30.0);

    assertThat(offM()).isLessThan(0.1);
    assertThat(state().ySigma().orElseThrow()).isBetween(0.2, 1.0);

    hasVelocityLog = false;
    dive(3.0);
    assertThat(state().x()).isEmpty();
  }

  @Test
  void swap_forComplementaryAndBack_positionIsNotLost() {
    hasInertial = true;
    hasTilt = true;
    U2SAService first = kit.start(FusingStateEstimator::new);
    surface();
    northM = 0.0;
    dive(10.0);
    U2SAService second = kit.swap(first, ComplementaryStateEstimator::new);
    dive(5.0);
    kit.swap(second, FusingStateEstimator::new);
    dive(10.0);

    assertThat(offM()).isLessThan(0.5);
  }
}
