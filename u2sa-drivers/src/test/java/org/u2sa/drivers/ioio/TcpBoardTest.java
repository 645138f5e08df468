package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import ioio.lib.api.exception.ConnectionLostException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The unmodified IOIO library against the firmware simulator over TCP, in real time. */
class TcpBoardTest {
  private final TcpBench on = new TcpBench();

  @AfterEach
  void close() {
    on.close();
  }

  @Test
  void connect_everyPin_worksBothWays() throws Exception {
    on.bench.volts(40, 1.0);
    on.bench.pulses(35, 1.2e-3);
    byte[] text = "hello".getBytes(StandardCharsets.US_ASCII);
    try (BoardConnector connector = on.connector()) {
      BoardPins pins = on.awaitBoard(connector).pins();
      pins.pulse(0, 1.75e-3);
      on.awaitWidth(1.75e-3);
      await().atMost(TcpBench.PATIENCE).until(() -> pins.volts().isPresent());
      assertThat(pins.volts().getAsDouble()).isCloseTo(1.0, within(0.01));
      await().atMost(TcpBench.PATIENCE).until(() -> pins.nextRadioPulse().isPresent());
      UartLine line = pins.gps().orElseThrow();
      line.write(text);
      on.bench.send(6, text);
      byte[] buffer = new byte[64];
      await()
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                line.send(on.clock.micros(), Optional.empty());
                return Arrays.equals(on.bench.received(7), text);
              });
      int[] count = new int[1];
      await()
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                byte[] part = new byte[64];
                int more = line.read(part);
                System.arraycopy(part, 0, buffer, count[0], more);
                count[0] += more;
                return count[0] == text.length;
              });
      assertThat(Arrays.copyOf(buffer, count[0])).isEqualTo(text);
    }
    on.awaitWidth(0.0); // after the close
  }

  @Test
  void power_offAndOn_pinsFloatAndBoardIsBack() throws Exception {
    try (BoardConnector connector = on.connector()) {
      BoardSession before = on.awaitBoard(connector);
      before.pins().pulse(0, 1.9e-3);
      on.awaitWidth(1.9e-3);
      on.server.power(false);
      assertThat(on.bench.width(10)).isZero();
      on.awaitLoss(connector);
      assertThatThrownBy(
              () -> {
                before.pins().pulse(0, 1.1e-3);
                before.pins().pulse(0, 1.2e-3);
              })
          .isInstanceOf(ConnectionLostException.class);
      on.server.power(true);
      on.awaitBoardAgain(connector).pins().pulse(0, 1.5e-3);
      on.awaitWidth(1.5e-3);
    }
  }

  @Test
  void session_cutAtManyBytes_boardIsBackAndNoThreadIsLeft() {
    for (int bytes = 0; bytes < 110; bytes += 27) {
      try (BoardConnector in =
          TcpBench.connector(new CutConnection(on.connection(), bytes, Integer.MAX_VALUE))) {
        on.awaitBoard(in);
      }
      try (BoardConnector out =
          TcpBench.connector(new CutConnection(on.connection(), Integer.MAX_VALUE, bytes))) {
        on.awaitBoard(out);
      }
    }
  }
}
