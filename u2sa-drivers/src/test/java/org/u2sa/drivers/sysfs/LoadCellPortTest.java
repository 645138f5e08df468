package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.drivers.link.FileBench;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedLoadCell;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every load cell behind a thruster that pushes forward with 30 N. */
class LoadCellPortTest extends DeviceContract<LoadCell.Load> {
  @TempDir static Path folder;

  @Override
  protected List<Bench<LoadCell.Load>> benches() {
    Path raw = folder.resolve("in_voltage0_raw");
    return List.of(
        new FileBench<>(
            "IIO",
            new IioLoadCell(raw, new IioLoadCell.Calibration(8_000.0, -0.005)),
            Map.of(raw, "2000\n")),
        new SimulatedBench<>(
            "simulated",
            new SimulatedLoadCell(
                new SensorErrors(20.0, 0.0, 0.5, 0.5, 0.0), new NoiseStreams(1), () -> 30.0)));
  }

  @Override
  protected void judge(LoadCell.Load load) {
    assertThat(load.newtons()).isCloseTo(30.0, within(4.0));
  }
}
