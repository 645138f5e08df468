package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.drivers.link.FileBench;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.device.SimulatedEncoder;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every pair of encoders, after two turns forward on the left and one back on the right. */
class WheelEncoderPortTest extends DeviceContract<WheelEncoder.Ticks> {
  @TempDir static Path folder;

  @Override
  protected List<Bench<WheelEncoder.Ticks>> benches() {
    Path left = folder.resolve("left");
    Path right = folder.resolve("right");
    return List.of(
        new FileBench<>(
            "Linux counter",
            new LinuxCounter(left, right),
            Map.of(left, "2000\n", right, "4294966296\n")), // as unsigned 32 bits
        new SimulatedBench<>(
            "simulated",
            new SimulatedEncoder(
                20.0,
                1000.0,
                0.0,
                new NoiseStreams(1),
                () -> 4.0 * Math.PI,
                () -> -2.0 * Math.PI)));
  }

  @Override
  protected void judge(WheelEncoder.Ticks ticks) {
    assertThat(ticks.left()).isEqualTo(2000);
    assertThat(ticks.right()).isEqualTo(-1000);
  }
}
