package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.BarometerSensor;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.GroundPressure;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedBarometer;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.ServiceKit;

/** A barometer 100 m above the sea on a day of 1003.25 hPa, told by a ground station or not. */
class GroundPressureTest {
  private static final double QNH_PA = 100_325.0;
  private static final double UP_M = 100.0;

  private final ServiceKit kit = new ServiceKit();

  @BeforeEach
  void begin() {
    SimulatedBarometer device =
        new SimulatedBarometer(
            new SensorErrors(20.0, 0.0, 0.0, 0.0, 0.0), QNH_PA, new NoiseStreams(1), () -> UP_M);
    kit.start(context -> new BarometerSensor(context, device));
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private void tell(double pascals) {
    kit.publish(Channels.GROUND_PRESSURE, new GroundPressure().operator("ann").pressure(pascals));
  }

  /** The vehicle knows its altitude for a time. */
  private void fly(double seconds, double sigmaM) {
    for (double gone = 0.0; gone < seconds; gone += 0.5) {
      StateInformation state = new StateInformation().sensorName("estimator");
      state.referenceFrame(ReferenceFrame.GLOBAL).z(UP_M).zSigma(sigmaM);
      state.timestamp(kit.clock().micros());
      kit.publish(Channels.STATE, state);
      kit.advance(0.5);
    }
  }

  private StateInformation sensed() {
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  private List<String> remarks() {
    kit.advance(1.0);
    return kit.latest(Channels.HEALTH).map(HealthReport::remarks).orElseThrow();
  }

  @Test
  void told_pressureAtTheStation_isReducedToSeaLevelAndUsed() {
    // 1003.25 hPa at the sea are 5.2 hPa less at 43.3 m
    kit.publish(
        Channels.GROUND_PRESSURE, new GroundPressure().operator("ann").pressure(99_805.0).z(43.3));
    kit.advance(1.0);
    assertThat(sensed().z().orElseThrow()).isCloseTo(UP_M, within(0.5));
    assertThat(sensed().zSigma()).hasValue(5.0);
    assertThat(remarks()).anyMatch(each -> each.startsWith("QNH: 1003.2 hPa, from ann"));
  }

  @Test
  void told_beforeTheFirstReading_isNotReplacedByTheConfiguredOne() {
    try (ServiceKit early = new ServiceKit()) {
      SimulatedBarometer device =
          new SimulatedBarometer(
              new SensorErrors(20.0, 0.0, 0.0, 0.0, 0.0), QNH_PA, new NoiseStreams(1), () -> UP_M);
      early.publish(
          Channels.GROUND_PRESSURE, new GroundPressure().operator("ann").pressure(QNH_PA));
      early.start(context -> new BarometerSensor(context, device));
      early.advance(1.0);
      assertThat(early.latest(Channels.SENSED_STATE).orElseThrow().z().orElseThrow())
          .isCloseTo(UP_M, within(0.5));
    }
  }

  @Test
  void nobodyTells_tenHectopascalsOff_isDetectedAndFittedToTheAltitude() {
    fly(5.0, 2.0);
    assertThat(sensed().z().orElseThrow() - UP_M).as("not yet").isGreaterThan(80.0);
    fly(10.0, 2.0);
    assertThat(sensed().z().orElseThrow()).isCloseTo(UP_M, within(0.5));
    assertThat(sensed().zSigma()).hasValue(10.0);
    assertThat(remarks()).anyMatch(each -> each.startsWith("QNH: 1003.2 hPa, fitted"));
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().lastError().orElseThrow())
        .contains("QNH 1013.3 hPa", "contradicts the altitude by 84 m");
  }

  @Test
  void nobodyTells_altitudeUncertain_nothingIsConcluded() {
    fly(30.0, 15.0);
    assertThat(sensed().z().orElseThrow() - UP_M).isGreaterThan(80.0);
    assertThat(remarks()).anyMatch(each -> each.contains("configured; no station sent one"));
  }

  @Test
  void told_tenHectopascalsWrongWhileTheAltitudeIsKnown_isRefused() {
    tell(QNH_PA);
    fly(3.0, 2.0);
    tell(QNH_PA + 1_000.0);
    fly(1.0, 2.0);
    assertThat(sensed().z().orElseThrow()).isCloseTo(UP_M, within(0.5));
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().lastError().orElseThrow())
        .contains("1013.3 hPa from ann is refused");
  }

  @Test
  void told_hoursAgoOrImpossible_isRefused() {
    kit.advance(4_000.0);
    GroundPressure old = new GroundPressure().operator("ann").pressure(QNH_PA);
    old.timestamp(0L);
    kit.publish(Channels.GROUND_PRESSURE, old);
    kit.advance(1.0);
    assertThat(remarks()).anyMatch(each -> each.contains("no station sent one"));
    tell(60_000.0);
    kit.advance(1.0);
    assertThat(remarks()).anyMatch(each -> each.contains("no station sent one"));
  }
}
