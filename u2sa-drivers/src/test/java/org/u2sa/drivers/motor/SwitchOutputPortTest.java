package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.drivers.link.FileBench;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.sysfs.SysfsOutput;
import org.u2sa.sim.payload.SimulatedSwitch;
import org.u2sa.testkit.DeviceContract;

/** Every output of switched payloads, at 25 %. */
class SwitchOutputPortTest extends DeviceContract<SwitchOutput.Level> {
  @TempDir static Path folder;

  @Override
  protected List<Bench<SwitchOutput.Level>> benches() {
    MemoryLink link = new MemoryLink();
    ServoSwitch servo = // pulses of 1200 to 1800 µs
        new ServoSwitch(new Maestro(link, ServoPortTest.WIRING), -0.5, 0.5);
    new SimulatedMaestro(link);
    servo.set(25.0);
    Path file = folder.resolve("duty_cycle");
    SysfsOutput sysfs = new SysfsOutput(file, new SysfsOutput.Range(1_000_000.0, 2_000_000.0));
    sysfs.set(25.0);
    SimulatedSwitch simulated = new SimulatedSwitch(20.0, 0.5);
    simulated.set(25.0);
    return List.of(
        new LinkedBench<>("MAESTRO", link, servo, Long.MAX_VALUE, line -> {}),
        new FileBench<>("SYSFS", sysfs, Map.of(file, "1250000")),
        new SimulatedBench<>("simulated", simulated));
  }

  @Override
  protected void judge(SwitchOutput.Level level) {
    assertThat(level.percent().orElseThrow()).isCloseTo(25.0, within(0.1));
  }
}
