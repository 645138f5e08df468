package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateInformation;

/** What the service tells of GPS, compass and battery at the board. */
class IoioSensingTest {
  private final BoardKit on = new BoardKit();

  @AfterEach
  void close() {
    on.close();
  }

  private static String sentence(String body) {
    int sum = 0;
    for (char letter : body.toCharArray()) {
      sum ^= letter;
    }
    return String.format("$%s*%02X\r\n", body, sum);
  }

  /**
   * A position at 36 deg north, 78 deg west; the receiver's fix is known when the next one comes.
   */
  private void gps(int second, double knots, double courseDeg) {
    String body =
        String.format(
            Locale.ROOT,
            "GPRMC,1200%02d.00,A,3600.0000,N,07800.0000,W,%.2f,%.1f,211126,,,A",
            second,
            knots,
            courseDeg);
    on.bench.send(6, sentence(body).getBytes(StandardCharsets.US_ASCII));
  }

  private void compass(double degrees) {
    String body = String.format(Locale.ROOT, "HCHDT,%.1f,T", degrees);
    on.bench.send(13, sentence(body).getBytes(StandardCharsets.US_ASCII));
  }

  private List<StateInformation> measured(String sensor) {
    return on.kit.published(Channels.SENSED_STATE).stream()
        .filter(each -> each.sensorName().equals(sensor))
        .toList();
  }

  /** One fix counts once, however often the compass measures. */
  @Test
  void step_fixesAndHeadings_areEachPublishedOnceAtTheirOwnTime() {
    on.start();
    for (int second = 1; second <= 3; second++) {
      gps(second, 4.0, 90.0);
      for (int i = 0; i < 5; i++) {
        compass(90.0 + i);
        on.kit.advance(0.1);
      }
    }
    List<StateInformation> fixes = measured("IoioService GPS");
    assertThat(fixes).as("the last one waits for the next time").hasSize(2);
    StateInformation fix = fixes.get(1);
    assertThat(fix.x().orElseThrow()).isCloseTo(-78.0, within(1e-9));
    assertThat(fix.xDot().orElseThrow()).isCloseTo(4.0 * 1852.0 / 3600.0, within(1e-6));
    assertThat(fix.psi()).as("measured by another").isEmpty();
    assertThat(fix.timestamp().getAsLong() - fixes.get(0).timestamp().getAsLong())
        .isCloseTo(500_000L, within(30_000L));
    List<StateInformation> headings = measured("IoioService compass");
    assertThat(headings).hasSizeGreaterThan(10);
    assertThat(headings)
        .allSatisfy(
            heading -> {
              assertThat(heading.x()).isEmpty();
              assertThat(heading.xSigma()).isEmpty();
              assertThat(heading.psiSigma()).hasValue(Math.toRadians(1.0));
            });
    assertThat(headings.stream().map(StateInformation::timestamp).distinct())
        .hasSameSizeAs(headings);
  }

  @Test
  void step_delaysAreKnown_measurementsHaveTheTimeThatTheyAreOf() {
    on.kit.with("GPS DELAY", 0.5).with("COMPASS DELAY", 0.25);
    on.start();
    on.kit.advance(1.0);
    long sentMicros = on.kit.clock().micros();
    gps(1, 4.0, 90.0);
    compass(90.0);
    on.kit.advance(0.1);
    gps(2, 4.0, 90.0); // the fix before is whole
    on.kit.advance(0.1);

    assertThat(measured("IoioService GPS").get(0).timestamp().getAsLong())
        .isBetween(sentMicros - 500_000L, on.kit.clock().micros() - 500_000L);
    assertThat(measured("IoioService compass").get(0).timestamp().getAsLong())
        .isCloseTo(sentMicros - 250_000L, within(50_000L));
  }

  @Test
  void step_withoutCompass_oneStateForEachFix() {
    on.kit.with("COMPASS RX PIN", -1);
    on.start();
    for (int second = 1; second <= 4; second++) {
      gps(second, 0.0, 0.0);
      on.kit.advance(0.25);
    }
    assertThat(on.kit.published(Channels.SENSED_STATE).size()).isBetween(3, 4);
    assertThat(on.kit.latest(Channels.SENSED_STATE).orElseThrow().psi()).isEmpty();
  }

  @Test
  void step_garbageOfDevices_isCountedAndSurvived() {
    on.start();
    on.bench.send(6, "$GPRMC,nonsense*00\r\n".repeat(4).getBytes(StandardCharsets.US_ASCII));
    on.kit.advance(0.5);
    assertThat(on.lastError().orElseThrow()).contains("the GPS receiver sent invalid data");
    assertThat(on.kit.latest(Channels.HEALTH).orElseThrow().exceptions()).isZero();
  }

  @Test
  void step_battery_isTheVoltageBeforeTheDivider() {
    on.start();
    on.kit.advance(1.0);
    BatteryState battery = on.kit.latest(Channels.POWER).orElseThrow();
    assertThat(battery.voltage().orElseThrow()).isCloseTo(12.0, within(0.05));
    assertThat(on.kit.published(Channels.POWER).size()).isLessThanOrEqualTo(2);
  }
}
