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
import org.u2sa.messages.frame.Geodetic;

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

  private static Geodetic place(StateInformation state) {
    return new Geodetic(state.x().orElseThrow(), state.y().orElseThrow(), 0.0);
  }

  @Test
  void step_fixAndHeadings_areOneStateForEachHeading() {
    on.start();
    gps(1, 4.0, 90.0);
    on.kit.advance(0.2);
    gps(2, 4.0, 90.0);
    on.kit.advance(0.2);
    assertThat(on.kit.published(Channels.SENSED_STATE)).isEmpty();
    compass(90.0);
    on.kit.advance(0.1);
    compass(350.0);
    on.kit.advance(0.4);

    List<StateInformation> states = on.kit.published(Channels.SENSED_STATE);
    assertThat(states).hasSize(2);
    assertThat(states.get(0).psi().orElseThrow()).isCloseTo(Math.PI / 2.0, within(1e-9));
    assertThat(states.get(1).psi().orElseThrow()).isCloseTo(Math.toRadians(350.0), within(1e-9));
    double eastMps = 4.0 * 1852.0 / 3600.0;
    assertThat(states.get(1).xDot().orElseThrow()).isCloseTo(eastMps, within(1e-6));
    assertThat(states.get(1).yDot().orElseThrow()).isCloseTo(0.0, within(1e-6));
    assertThat(states.get(1).psiSigma()).hasValue(Math.toRadians(1.0));
    Geodetic first = place(states.get(0));
    Geodetic second = place(states.get(1));
    double betweenS =
        (states.get(1).timestamp().orElseThrow() - states.get(0).timestamp().orElseThrow()) * 1e-6;
    assertThat(betweenS).isBetween(0.08, 0.12);
    assertThat(first.distanceM(second)).isCloseTo(eastMps * betweenS, within(1e-3));
    assertThat(first.bearingRad(second)).isCloseTo(Math.PI / 2.0, within(1e-3));
  }

  @Test
  void step_fixTooOld_headingAlone() {
    on.start();
    gps(1, 0.0, 0.0);
    on.kit.advance(0.2);
    gps(2, 0.0, 0.0);
    on.kit.advance(0.2);
    compass(44.0);
    on.kit.advance(0.1);
    assertThat(on.kit.latest(Channels.SENSED_STATE).orElseThrow().x()).isPresent();
    on.kit.advance(2.5);
    compass(45.0);
    on.kit.advance(0.1);
    StateInformation state = on.kit.latest(Channels.SENSED_STATE).orElseThrow();
    assertThat(state.psi().orElseThrow()).isCloseTo(Math.PI / 4.0, within(1e-9));
    assertThat(state.x()).isEmpty();
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
    assertThat(on.lastError().orElseThrow()).contains("the GPS receiver sent what cannot be read");
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
