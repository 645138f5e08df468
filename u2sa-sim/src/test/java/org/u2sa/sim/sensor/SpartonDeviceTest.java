package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

class SpartonDeviceTest {
  private static final double EAST = Math.PI / 2.0;
  private final SpartonDevice compass =
      new SpartonDevice(9_600, CompassParameters.perfect(0.0), new NoiseStreams(1L));
  private long nowUs;

  @Test
  void accept_magneticHeading_answersInPartsOf4096() {
    face(EAST);
    assertThat(answer(0xA4, 0x09, 0xA0)).containsExactly(0xA4, 0x09, 0x04, 0x00, 0xA0);
  }

  @Test
  void accept_declination_countsForTrueHeading() {
    face(EAST);
    assertThat(answer(0xA4, 0x83, 0xFC, 0x7C, 0xA0)) // −90.0°
        .containsExactly(0xA4, 0x83, 0xFC, 0x7C, 0xA0);
    assertThat(answer(0xA4, 0x02, 0xA0)).containsExactly(0xA4, 0x02, 0x00, 0x00, 0xA0);
    assertThat(answer(0xA4, 0x09, 0xA0)).containsExactly(0xA4, 0x09, 0x04, 0x00, 0xA0);
  }

  @Test
  void accept_headingJustBelowNorth_wrapsToZero() {
    face(2.0 * Math.PI - 1e-6);
    assertThat(answer(0xA4, 0x09, 0xA0)).containsExactly(0xA4, 0x09, 0x00, 0x00, 0xA0);
  }

  @Test
  void accept_garbageBefore_isPassedOver() {
    face(EAST);
    assertThat(answer(0x00, 0x55, 0xA0, 0xA4, 0x06, 0xA0))
        .containsExactly(0xA4, 0x06, 0, 0, 0, 0, 0xA0);
  }

  @Test
  void accept_unknownCommand_isAnErrorAndWithoutEndNothing() {
    face(EAST);
    assertThat(answer(0xA4, 0x7F, 0xA0)).containsExactly(0xAE, 0x7F, 0xA0);
    assertThat(answer(0xA4, 0x09, 0x33)).isEmpty();
    assertThat(answer(0xA4, 0x09, 0xA0)).hasSize(5);
  }

  @Test
  void accept_baud_echoesAtBothRates() {
    face(EAST);
    byte[] request = {(byte) 0xA4, 0x57, 0x08, (byte) 0xA0};
    compass.accept(nowUs, 9_600, request, request.length);
    byte[] buffer = new byte[16];
    assertThat(compass.line().take(nowUs + 4_200, 9_600, buffer)).isEqualTo(4);
    assertThat(compass.line().take(nowUs + 5_000, 115_200, buffer)).isEqualTo(4);
    nowUs += 10_000;
    assertThat(answer(115_200, new int[] {0xA4, 0x09, 0xA0})).hasSize(5);
  }

  private void face(double headingRad) {
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.of(0, 0, 0),
            new Attitude(0.0, 0.0, headingRad),
            Point.of(0, 0, 0),
            Point.ORIGIN,
            Point.ORIGIN);
    compass.advance(nowUs, truth, CompassModel.Disturbance.none());
  }

  private int[] answer(int... request) {
    return answer(9_600, request);
  }

  private int[] answer(int baud, int[] request) {
    byte[] bytes = new byte[request.length];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) request[i];
    }
    compass.accept(nowUs, baud, bytes, bytes.length);
    nowUs += 20_000;
    byte[] buffer = new byte[64];
    int length = compass.line().take(nowUs, baud, buffer);
    int[] answer = new int[length];
    Arrays.setAll(answer, i -> buffer[i] & 0xFF);
    return answer;
  }
}
