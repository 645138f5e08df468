package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import ioio.lib.api.IOIOConnection;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.ioio.IoioInProcess;

/** The unmodified IOIO library against the firmware simulator, in lockstep. */
class BoardConnectorTest {
  static final PinPlan PLAN =
      new PinPlan(
          List.of(10, 11),
          50,
          Optional.of(new PinPlan.Uart(6, 7, 9600)),
          Optional.of(new PinPlan.Uart(13, 14, 115_200)),
          35,
          40,
          40,
          0);
  private static final double QUARTER_TICK_S = 0.125e-6;
  private static final double STEP_S = 0.01;

  private final Bench bench = new Bench();
  private final IoioInProcess board = new IoioInProcess(bench.firmware);
  private final BoardConnector connector = new BoardConnector(connection(board), PLAN, 1.0);
  private long nowMicros;

  static BoardConnection connection(IoioInProcess board) {
    return new LockstepConnection(
        board::connect, board::disconnect, board::input, board::output, board::exchange);
  }

  @AfterEach
  void close() {
    connector.close();
    LibraryThreads.awaitNone();
  }

  private BoardPins pins() {
    return connector.session().orElseThrow().pins();
  }

  private void advance(double seconds) {
    for (int i = 0; i < Math.round(seconds / STEP_S); i++) {
      nowMicros += 10_000;
      connector.step(nowMicros);
    }
  }

  @Test
  void step_boardThere_isConnectedAndSaysWhatItIs() {
    connector.step(0);
    assertThat(connector.session()).isPresent();
    assertThat(connector.trouble()).isEmpty();
    assertThat(connector.session().orElseThrow().versions())
        .isEqualTo("hardware SPRK0020, boot loader IOIO0402, firmware IOIO0506, library IOIO0507");
  }

  @Test
  void start_libraryFailsUnexpectedly_saysSoAndTriesOn() throws InterruptedException {
    CountDownLatch attempts = new CountDownLatch(2);
    BoardConnector inRealTime =
        new BoardConnector(
            new BoardConnection() {
              @Override
              public IOIOConnection newConnection() {
                attempts.countDown();
                throw new UnsupportedOperationException("odd");
              }

              @Override
              public String address() {
                return "nowhere";
              }
            },
            PLAN,
            1.0);
    inRealTime.start();
    assertThat(attempts.await(60, TimeUnit.SECONDS)).isTrue();
    inRealTime.close();
    assertThat(inRealTime.trouble()).contains("odd");
  }

  @Test
  void pulse_widths_arriveAtThePinWithinTheBoardsResolution() throws Exception {
    connector.step(0);
    assertThat(bench.width(10)).as("before the first").isZero();
    for (double us = 900.0; us < 2200.0; us += 0.93) {
      pins().pulse(0, us * 1.0e-6);
      assertThat(bench.width(10)).isCloseTo(us * 1.0e-6, within(QUARTER_TICK_S));
    }
    assertThat(bench.width(11)).as("the other").isZero();
  }

  @Test
  void uart_bothWays_bytesArriveUnchanged() throws Exception {
    connector.step(0);
    byte[] sent = new byte[600];
    for (int i = 0; i < sent.length; i++) {
      sent[i] = (byte) i;
    }
    UartLine line = pins().gps().orElseThrow();
    line.write(sent);
    byte[] buffer = new byte[1024];
    int read = 0;
    bench.send(6, sent);
    for (int i = 0; i < 150; i++) {
      advance(STEP_S);
      line.send(nowMicros, connector.session().orElseThrow().lockstep());
      byte[] part = new byte[1024];
      int count = line.read(part);
      System.arraycopy(part, 0, buffer, read, count);
      read += count;
    }
    assertThat(bench.received(7)).isEqualTo(sent);
    assertThat(Arrays.copyOf(buffer, read)).isEqualTo(sent);
  }

  @Test
  void volts_battery_isMeasuredWithinOneStepOfTheConverter() throws Exception {
    bench.volts(40, 2.5);
    connector.step(0);
    assertThat(pins().volts()).isEmpty();
    advance(STEP_S);
    assertThat(pins().volts().orElseThrow()).isCloseTo(2.5, within(3.3 / 1023 * 2));
  }

  @Test
  void nextRadioPulse_receiver_isEachOneOnce() throws Exception {
    bench.pulses(35, 1.9e-3);
    connector.step(0);
    advance(0.105); // pulses end at 21.9, 41.9, 61.9, 81.9, 101.9 ms
    for (int i = 0; i < 4; i++) {
      assertThat(pins().nextRadioPulse().orElseThrow()).isCloseTo(1.9e-3, within(0.6e-6));
    }
    advance(0.01);
    assertThat(pins().nextRadioPulse()).isPresent();
    assertThat(pins().nextRadioPulse()).isEmpty();
    assertThat(Thread.currentThread().isInterrupted()).isFalse();
  }

  @Test
  void nextRadioPulse_interruptedThread_staysInterrupted() throws Exception {
    connector.step(0);
    Thread.currentThread().interrupt();
    assertThat(pins().nextRadioPulse()).isEmpty();
    assertThat(Thread.interrupted()).isTrue();
  }

  @Test
  void light_led_isLitLow() throws Exception {
    connector.step(0);
    assertThat(bench.level(0)).isTrue();
    pins().light(true);
    assertThat(bench.level(0)).isFalse();
    pins().light(false);
    assertThat(bench.level(0)).isTrue();
  }

  @Test
  void step_powerCycle_pinsFloatAndComeBackWithinTwoSeconds() throws Exception {
    connector.step(0);
    pins().pulse(0, 1.8e-3);
    board.power(false);
    assertThat(bench.width(10)).isZero();
    advance(1.0);
    assertThat(connector.session()).isEmpty();
    assertThat(connector.trouble()).contains("no power");
    board.power(true);
    advance(0.5);
    assertThat(connector.session()).isPresent();
    assertThat(bench.width(10)).as("no pulse before one is set").isZero();
    pins().pulse(0, 1.5e-3);
    assertThat(bench.width(10)).isCloseTo(1.5e-3, within(QUARTER_TICK_S));
  }

  @Test
  void step_garbageFromTheHost_boardHangsUpAndIsConnectedAnew() throws IOException {
    connector.step(0);
    BoardSession before = connector.session().orElseThrow();
    board.output().write(0xEE);
    advance(0.3);
    assertThat(bench.firmware.isOpen()).isTrue();
    assertThat(connector.session().orElseThrow()).isNotSameAs(before);
  }

  @Test
  void close_pulsesSet_pinsFloat() throws Exception {
    connector.step(0);
    pins().pulse(1, 1.8e-3);
    connector.close();
    assertThat(bench.width(11)).isZero();
    assertThat(bench.level(11)).isNull();
  }

  @Test
  void connect_pinsOfAnotherBoard_saysWhichPin() {
    PinPlan wrong = new PinPlan(List.of(20), 50, Optional.empty(), Optional.empty(), -1, -1, 31, 0);
    try (BoardConnector other = new BoardConnector(connection(board), wrong, 1.0)) {
      other.step(0);
      assertThat(other.session()).isEmpty();
      assertThat(other.trouble()).contains("Pin 20", "peripheral output");
    }
  }

  @Test
  void uart_text_goesOutAtTheLinesPace() throws Exception {
    connector.step(0);
    UartLine line = pins().compass().orElseThrow();
    line.write("$PSPA,QUEST\r\n".getBytes(StandardCharsets.US_ASCII));
    for (int i = 0; i < 3; i++) {
      advance(STEP_S);
      line.send(nowMicros, connector.session().orElseThrow().lockstep());
    }
    advance(STEP_S);
    assertThat(new String(bench.received(14), StandardCharsets.US_ASCII))
        .isEqualTo("$PSPA,QUEST\r\n");
  }
}
