package org.u2sa.drivers.imu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.Heading;
import org.u2sa.device.port.Orientation;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedImu;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every IMU: 20° to the right, 10° nose down, heading east, each rate another one. */
class ImuPortTest extends DeviceContract<Orientation> {
  private static final Orientation TRUTH =
      new Orientation(
          0,
          Math.toRadians(20.0),
          Math.toRadians(-10.0),
          new Heading(0, Math.PI / 2.0, false),
          0.1,
          0.2,
          0.3,
          Optional.of(Point.of(1.7, -3.3, -9.1)));

  @Override
  protected List<Bench<Orientation>> benches() {
    MemoryLink link = new MemoryLink();
    return List.of(
        new LinkedBench<>(
            "VectorNav",
            link,
            new VectorNav(link),
            50_000,
            line ->
                line.fromDevice(
                    Nmea.bytes(
                        "VNYMR,+090.000,-010.000,+020.000,0,0,0,1.7,-3.3,-9.1,0.1,0.2,0.3"))),
        new SimulatedBench<>(
            "simulated",
            new SimulatedImu(SimulatedImu.Errors.vn100(), new NoiseStreams(1), () -> TRUTH)));
  }

  @Override
  protected void judge(Orientation said) {
    assertThat(said.rollRad()).isCloseTo(TRUTH.rollRad(), within(0.05));
    assertThat(said.pitchRad()).isCloseTo(TRUTH.pitchRad(), within(0.05));
    assertThat(said.heading().headingRad()).isCloseTo(Math.PI / 2.0, within(0.2));
    assertThat(said.heading().isTrue()).isFalse();
    assertThat(said.xRateRadPerS()).isCloseTo(0.1, within(0.01));
    assertThat(said.yRateRadPerS()).isCloseTo(0.2, within(0.01));
    assertThat(said.zRateRadPerS()).isCloseTo(0.3, within(0.01));
    assertThat(said.specificForce().orElseThrow().distanceTo(Point.of(1.7, -3.3, -9.1)))
        .isLessThan(0.05);
  }
}
