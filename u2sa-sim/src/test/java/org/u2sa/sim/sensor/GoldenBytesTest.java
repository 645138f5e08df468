package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The emitters still send the bytes that outside decoders have judged: {@code
 * scripts/sensors/check.py} reads the same files with pynmea2 and pyubx2.
 *
 * <p>{@code -Du2sa.golden.write=true} writes them again, to be judged again.
 */
class GoldenBytesTest {
  private static final UtcTime UTC = new UtcTime(Instant.parse("2026-11-21T23:59:58.5Z"));
  private static final Path FILES = Path.of("src/test/resources/sensor");

  // corners: both hemispheres, minutes that round up to 60, midnight, courses near north, no fix
  private static final List<GpsSample> SAMPLES =
      List.of(
          sample(0.0, 37.2283843, -80.4234167, 633.251, 0.5, 1.25, -0.02),
          sample(0.7, -33.999999999, 151.2099, 12.0, -0.25, -1.0, 0.1),
          sample(1.4, 0.0, 179.9999999999, -3.5, -0.0001, 1.5, 0.0),
          sample(1.5, 89.12345678, -0.0000001, 0.0, 0.0, 0.0, 0.0),
          new GpsSample(1.6, false, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
          new GpsSample(99.123, true, 51.5, 7.25, 100, 3, -4, 0, 3.04, 4.56, 0.15, 9, 1));

  private static GpsSample sample(
      double timeS, double lat, double lon, double alt, double east, double north, double up) {
    return new GpsSample(timeS, true, lat, lon, alt, east, north, up, 0.02, 0.03, 0.03, 16, 4);
  }

  @ParameterizedTest
  @ValueSource(strings = {"gps.nmea", "gps-precise.nmea", "gps.ubx", "compass.nmea"})
  void emitters_cornerCases_sendTheJudgedBytes(String file) throws IOException {
    byte[] emitted = emitted(file);
    if (Boolean.getBoolean("u2sa.golden.write")) {
      Files.write(FILES.resolve(file), emitted);
    }
    try (InputStream golden = GoldenBytesTest.class.getResourceAsStream("/sensor/" + file)) {
      assertThat(emitted).isEqualTo(golden.readAllBytes());
    }
  }

  private static byte[] emitted(String file) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    NmeaGpsMessages nmea = new NmeaGpsMessages(UTC, file.startsWith("gps-precise") ? 7 : 5);
    UbxGpsMessages ubx = new UbxGpsMessages(UTC);
    if (file.startsWith("compass")) {
      for (double heading : new double[] {0.0, 1.0, Math.PI, 6.2831, 6.28}) {
        out.write(NmeaCompassDevice.bytes(NmeaCompassDevice.Sentence.HDT, heading, 0.0));
        out.write(NmeaCompassDevice.bytes(NmeaCompassDevice.Sentence.HDM, heading, 0.0));
        out.write(NmeaCompassDevice.bytes(NmeaCompassDevice.Sentence.HDG, heading, -0.15));
      }
      return out.toByteArray();
    }
    for (GpsSample sample : SAMPLES) {
      if (file.endsWith(".ubx")) {
        out.write(ubx.posllh(sample));
        out.write(ubx.status(sample));
        out.write(ubx.sol(sample));
        out.write(ubx.velned(sample));
        out.write(ubx.pvt(sample));
      } else {
        out.write(nmea.gga(sample));
        out.write(nmea.rmc(sample));
        out.write(nmea.vtg(sample));
        out.write(nmea.gst(sample));
      }
    }
    return out.toByteArray();
  }
}
