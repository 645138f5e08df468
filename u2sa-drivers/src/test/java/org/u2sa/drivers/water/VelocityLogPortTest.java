package org.u2sa.drivers.water;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedVelocityLog;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.DeviceContract;

/** Every velocity log: 1 m/s ahead and 0.3 m/s to the right over the bottom. */
class VelocityLogPortTest extends DeviceContract<VelocityLog.Speeds> {
  private static final VehicleTruth TRUTH =
      new VehicleTruth(
          0.0,
          Point.ORIGIN,
          new Attitude(0.0, 0.0, Math.PI / 2.0), // to the east
          Point.of(1.0, -0.3, 0.0),
          Point.ORIGIN,
          Point.ORIGIN);

  @Override
  protected List<Bench<VelocityLog.Speeds>> benches() {
    MemoryLink dvl = new MemoryLink();
    MemoryLink nmea = new MemoryLink();
    return List.of(
        new LinkedBench<>(
            "Water Linked",
            dvl,
            SerialVelocityLog.waterLinked(dvl),
            100_000,
            line -> line.fromDevice(Lines.waterLinked("wrz,1.000,0.300,0.000,y,2.00,0.010"))),
        new LinkedBench<>(
            "NMEA",
            nmea,
            SerialVelocityLog.nmea(nmea),
            100_000,
            line -> line.fromDevice(Nmea.bytes("VDVBW,1.944,0.583,A,1.944,0.583,A,,V,,V"))),
        new SimulatedBench<>(
            "simulated",
            new SimulatedVelocityLog(
                new SensorErrors(5.0, 0.1, 0.01, 0.002, 0.1),
                50.0,
                new NoiseStreams(1),
                () -> TRUTH,
                () -> Point.ORIGIN,
                () -> 10.0)));
  }

  @Override
  protected void judge(VelocityLog.Speeds speeds) {
    assertThat(speeds.groundX().orElseThrow()).isCloseTo(1.0, within(0.08));
    assertThat(speeds.groundY().orElseThrow()).as("left").isCloseTo(-0.3, within(0.08));
  }

  /** Lines of a DVL, with a CRC-8 of the test's own. */
  static final class Lines {
    private Lines() {}

    static byte[] waterLinked(String text) {
      int crc = 0;
      for (byte each : text.getBytes(US_ASCII)) {
        crc ^= each;
        for (int i = 0; i < 8; i++) {
          crc = crc << 1 ^ ((crc & 0x80) != 0 ? 0x107 : 0);
        }
      }
      return String.format("%s*%02x\r\n", text, crc & 0xFF).getBytes(US_ASCII);
    }
  }
}
