package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedGps;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.UbloxReceiver;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.sensor.UtcTime;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.testkit.DeviceContract;

/** Every satellite receiver, north-east of Blacksburg, moving north at 5 m/s. */
class GpsPortTest extends DeviceContract<GpsFix> {
  private static final int BAUD = 9600;

  private int second;

  @Override
  protected List<Bench<GpsFix>> benches() {
    MemoryLink nmea = new MemoryLink();
    LocalPlane plane = new LocalPlane(new Geodetic(-80.42, 37.225, 634.2));
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.of(0.0, 0.0, 0.0),
            new Attitude(0.0, 0.0, 0.0),
            Point.of(0.0, 5.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN);
    return List.of(
        new LinkedBench<>(
            "NMEA", nmea, LinkedGps.listening(nmea, new NmeaGps()), 200_000, this::sayNmea),
        ublox(plane, truth),
        new SimulatedBench<>(
            "simulated",
            new SimulatedGps(
                GpsParameters.survey(), plane, new NoiseStreams(1), () -> truth, () -> false)));
  }

  /** Bytes and setup of a u-blox 8, as the simulation makes them. */
  private static Bench<GpsFix> ublox(LocalPlane plane, VehicleTruth truth) {
    UbloxReceiver far =
        new UbloxReceiver(
            UbloxSettings.factory(),
            GpsParameters.survey(),
            plane,
            new UtcTime(Instant.EPOCH),
            new NoiseStreams(1));
    MemoryLink link = new MemoryLink();
    byte[] heard = new byte[1024];
    long[] now = new long[1];
    link.with(bytes -> far.accept(now[0], BAUD, bytes, bytes.length));
    return new LinkedBench<>(
        "u-blox", link, LinkedGps.ublox(link, UbloxModel.UBLOX_8, BAUD, 5.0), 10_000, line -> {}) {
      @Override
      public void live(long nowMicros) {
        now[0] = nowMicros;
        far.advance(nowMicros, truth, false);
        int count = far.line().take(nowMicros, BAUD, heard);
        if (link.isConnected()) {
          link.fromDevice(Arrays.copyOf(heard, count));
        }
      }
    };
  }

  private void sayNmea(MemoryLink link) {
    second++;
    String time = String.format("12%02d%02d.00", second / 60 % 60, second % 60);
    link.fromDevice(
        Nmea.bytes(
            "GPRMC," + time + ",A,3713.5000,N,08025.2000,W,9.719,0.0,211126,,,A",
            "GPGGA," + time + ",3713.5000,N,08025.2000,W,1,08,1.0,634.2,M,,M,,"));
  }

  @Override
  protected void judge(GpsFix fix) {
    assertThat(fix.valid()).isTrue();
    assertThat(fix.latitudeDeg()).isCloseTo(37.225, within(2e-6));
    assertThat(fix.longitudeDeg()).isCloseTo(-80.42, within(2e-6));
    assertThat(fix.altitudeM().orElseThrow()).isCloseTo(634.2, within(0.3));
    assertThat(fix.northMps().orElseThrow()).isCloseTo(5.0, within(0.3));
    assertThat(fix.eastMps().orElseThrow()).isCloseTo(0.0, within(0.3));
    assertThat(fix.horizontalSigmaM().orElseThrow()).isPositive();
  }
}
