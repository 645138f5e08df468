package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.Thruster;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.device.SimulatedThruster;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every thruster, at rest. */
class ThrusterPortTest extends DeviceContract<Thruster.Turning> {
  @Override
  protected List<Bench<Thruster.Turning>> benches() {
    MemoryLink link = new MemoryLink();
    LinkedBench<Thruster.Turning> vesc =
        new LinkedBench<>("VESC", link, new Vesc(link, 7), Long.MAX_VALUE, line -> {});
    new SimulatedVesc(link, vesc::nowMicros);
    return List.of(
        vesc,
        new SimulatedBench<>(
            "simulated",
            new SimulatedThruster(
                SimulatedThruster.Propeller.t200(), new NoiseStreams(1), "thruster")));
  }

  @Override
  protected void judge(Thruster.Turning turning) {
    assertThat(turning.rpm().orElseThrow()).isCloseTo(0.0, within(30.0));
    assertThat(turning.currentA().orElseThrow()).isCloseTo(0.0, within(0.1));
    assertThat(turning.batteryV().orElseThrow()).isCloseTo(16.0, within(0.01));
  }
}
