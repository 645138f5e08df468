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
import org.u2sa.sim.device.SimulatedBarometer;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every barometer, 1000 m above the sea on a standard day: 898.75 hPa. */
class BarometerPortTest extends DeviceContract<Pressure> {
  @TempDir static Path folder;

  @Override
  protected List<Bench<Pressure>> benches() {
    Path input = folder.resolve("in_pressure_input");
    Path raw = folder.resolve("in_pressure_raw");
    return List.of(
        new FileBench<>("IIO", new IioPressure(input, 1.0), Map.of(input, "89.875\n")),
        new FileBench<>("IIO, scaled", new IioPressure(raw, 0.001), Map.of(raw, "89875\n")),
        new SimulatedBench<>(
            "simulated",
            new SimulatedBarometer(
                new SensorErrors(20.0, 0.02, 3.0, 25.0, 0.0),
                101_325.0,
                new NoiseStreams(1),
                () -> 1_000.0)));
  }

  @Override
  protected void judge(Pressure pressure) {
    assertThat(pressure.pascals()).isCloseTo(89_875.0, within(90.0));
  }
}
