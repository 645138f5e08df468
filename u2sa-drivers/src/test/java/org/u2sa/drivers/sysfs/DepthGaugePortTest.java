package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.Pressure;
import org.u2sa.drivers.link.FileBench;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedDepthGauge;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every depth gauge, 10 m deep in the sea: 1025 · 9.80665 · 10 Pa more than at the surface. */
class DepthGaugePortTest extends DeviceContract<Pressure> {
  @TempDir static Path folder;

  @Override
  protected List<Bench<Pressure>> benches() {
    Path input = folder.resolve("in_pressure_input");
    return List.of(
        new FileBench<>("IIO", new IioPressure(input, 1.0), Map.of(input, "201.843\n")),
        new SimulatedBench<>(
            "simulated",
            new SimulatedDepthGauge(
                new SensorErrors(10.0, 0.02, 20.0, 1_000.0, 0.0),
                1025.0,
                new NoiseStreams(1),
                () -> 10.0)));
  }

  @Override
  protected void judge(Pressure pressure) {
    assertThat(pressure.pascals()).isCloseTo(201_843.0, within(4_000.0));
  }
}
