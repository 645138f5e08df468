package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.payload.Gimbal;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.payload.SimulatedGimbal;
import org.u2sa.testkit.DeviceContract;

/** Every gimbal, straight ahead. */
class GimbalPortTest extends DeviceContract<Gimbal.Pointing> {
  static final MavlinkGimbal.Variables FIRST = new MavlinkGimbal.Variables(1, 154, false);
  static final SimulatedGimbal.Drive DRIVE =
      new SimulatedGimbal.Drive(20.0, 2.0, -1.5, 0.5, 1.0, 0.1);

  @Override
  protected List<Bench<Gimbal.Pointing>> benches() {
    MemoryLink link = new MemoryLink();
    SimulatedMavlinkGimbal gimbal = new SimulatedMavlinkGimbal(link);
    return List.of(
        new LinkedBench<>(
            "MAVLINK",
            link,
            new MavlinkGimbal(link, FIRST),
            100_000,
            line -> line.fromDevice(gimbal.status(32, 0))),
        new SimulatedBench<>("simulated", new SimulatedGimbal(DRIVE)));
  }

  @Override
  protected void judge(Gimbal.Pointing pointing) {
    assertThat(pointing.panRad()).isCloseTo(0.0, within(1e-6));
    assertThat(pointing.tiltRad()).isCloseTo(0.0, within(1e-6));
  }
}
