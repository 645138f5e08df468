package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.GpsFix;

/**
 * Captures of a real receiver, with pynmea2 as the judge; where they are from and how the judge's
 * tables were made: resources/org/u2sa/drivers/gps/README.md.
 */
class NmeaCaptureTest {
  private static final double MPS_PER_KNOT = 0.514444444;
  private static final long SECOND_MICROS = 1_000_000;

  private static String resource(String name) throws IOException {
    try (InputStream in = NmeaCaptureTest.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.US_ASCII);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"landing", "standing"})
  void accept_realCapture_isUnderstoodAsByPynmea2(String name) throws IOException {
    List<GpsFix> fixes = fixes(resource(name + ".nmea"));
    List<String> rows = resource(name + ".csv").lines().skip(1).toList();

    assertThat(fixes).hasSameSizeAs(rows);
    for (int i = 0; i < rows.size(); i++) {
      judge(fixes.get(i), rows.get(i).split(",", -1), name + ".csv, row " + (i + 2));
    }
  }

  private static List<GpsFix> fixes(String capture) {
    NmeaGps gps = new NmeaGps();
    List<GpsFix> fixes = new ArrayList<>();
    long now = 0;
    for (byte each : capture.getBytes(StandardCharsets.US_ASCII)) {
      gps.accept(new byte[] {each}, 1, now);
      now += 1_000;
      gps.latest()
          .filter(fix -> fixes.isEmpty() || fixes.get(fixes.size() - 1) != fix)
          .ifPresent(fixes::add);
    }
    assertThat(gps.refused()).isZero();
    return fixes;
  }

  private static void judge(GpsFix fix, String[] row, String where) {
    assertThat(fix.valid()).as(where).isEqualTo(Boolean.parseBoolean(row[0]));
    if (!fix.valid()) {
      return;
    }
    assertThat(fix.latitudeDeg()).as(where).isCloseTo(Double.parseDouble(row[1]), within(1e-8));
    assertThat(fix.longitudeDeg()).as(where).isCloseTo(Double.parseDouble(row[2]), within(1e-8));
    assertThat(fix.altitudeM()).as(where).hasValue(Double.parseDouble(row[3]));
    double speed = MPS_PER_KNOT * Double.parseDouble(row[4]);
    double course = row[5].isEmpty() ? 0.0 : Math.toRadians(Double.parseDouble(row[5]));
    if (!row[5].isEmpty() || speed == 0.0) {
      assertThat(fix.eastMps().orElseThrow())
          .as(where)
          .isCloseTo(speed * Math.sin(course), within(1e-6));
      assertThat(fix.northMps().orElseThrow())
          .as(where)
          .isCloseTo(speed * Math.cos(course), within(1e-6));
    }
    assertThat(fix.satellites()).as(where).isEqualTo(Integer.parseInt(row[6]));
    assertThat(fix.horizontalSigmaM().orElseThrow()).as(where).isBetween(0.8, 10.0);
    assertThat(fix.measuredAtMicros()).isLessThan(100 * SECOND_MICROS);
  }
}
