package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.PitotTube;
import org.u2sa.drivers.link.FileBench;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedPitotTube;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.DeviceContract;

/** Every pitot tube, to the east over the sea at 40 m/s with 10 m/s from ahead: ½ · 1.225 · 50². */
class PitotTubePortTest extends DeviceContract<PitotTube.Impact> {
  @TempDir static Path folder;

  @Override
  protected List<Bench<PitotTube.Impact>> benches() {
    Path input = folder.resolve("in_pressure_input");
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.ORIGIN,
            new Attitude(0.0, 0.0, Math.PI / 2.0),
            Point.of(40.0, 0.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN);
    return List.of(
        new FileBench<>("IIO", new IioPitotTube(input, 1.0), Map.of(input, "1.5395\n")),
        new SimulatedBench<>(
            "simulated",
            new SimulatedPitotTube(
                new SensorErrors(20.0, 0.02, 3.0, 2.0, 0.0),
                new NoiseStreams(1),
                () -> truth,
                () -> Point.of(-10.0, 0.0, 0.0),
                () -> 0.0,
                Double.POSITIVE_INFINITY)));
  }

  @Override
  protected void judge(PitotTube.Impact impact) {
    // ½ρV²(1 + M²/4): 0.5 % more than without compression
    assertThat(impact.differentialPa()).isCloseTo(1539.5, within(20.0));
  }
}
