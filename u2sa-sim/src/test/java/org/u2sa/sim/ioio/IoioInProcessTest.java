package org.u2sa.sim.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class IoioInProcessTest {
  private static final int GREETING = 29;

  private final Bench bench = new Bench();
  private final IoioInProcess cable = new IoioInProcess(bench.firmware);
  private final ByteArrayOutputStream handedOver = new ByteArrayOutputStream();

  /** Reads as a host does, on a thread of its own, until the end. */
  private static CompletableFuture<byte[]> read(InputStream in) {
    return CompletableFuture.supplyAsync(
        () -> {
          ByteArrayOutputStream all = new ByteArrayOutputStream();
          try (in) {
            for (int octet = in.read(); octet >= 0; octet = in.read()) {
              all.write(octet);
            }
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
          return all.toByteArray();
        });
  }

  @Test
  void exchange_analogInput_hostHasTakenAllWhenItReturns() throws Exception {
    assertThat(cable.connect()).isTrue();
    CompletableFuture<byte[]> host = read(cable.input());
    OutputStream out = cable.output();
    out.write(new byte[] {0x0B, 40, 0x0C, (byte) (0x80 | 40)});
    cable.exchange(1_000_000, handedOver::writeBytes);
    cable.exchange(1_100_000, handedOver::writeBytes);
    cable.disconnect();
    byte[] taken = host.get(20, TimeUnit.SECONDS);
    assertThat(taken.length + handedOver.size())
        .isEqualTo(GREETING + 3 + 1100 * 3); // format, a value a millisecond
    assertThat(handedOver.size()).as("once the reader has waited").isEqualTo(100 * 3);
  }

  @Test
  void connect_withoutPower_isRefusedUntilItIsBack() {
    cable.power(false);
    assertThat(cable.connect()).isFalse();
    cable.exchange(10_000, handedOver::writeBytes); // time goes on all the same
    cable.power(true);
    assertThat(cable.connect()).isTrue();
  }

  @Test
  void power_off_endsTheStreamAndRefusesBytes() throws Exception {
    assertThat(cable.connect()).isTrue();
    CompletableFuture<byte[]> host = read(cable.input());
    OutputStream out = cable.output();
    cable.exchange(0, handedOver::writeBytes);
    cable.power(false);
    assertThat(host.get(20, TimeUnit.SECONDS)).hasSize(GREETING);
    assertThatThrownBy(() -> out.write(0x23)).isInstanceOf(IOException.class);
  }

  @Test
  void output_ofTheConnectionBefore_reachesNothing() throws Exception {
    cable.connect();
    OutputStream before = cable.output();
    InputStream inBefore = cable.input();
    cable.connect();
    assertThatThrownBy(() -> before.write(0x23)).isInstanceOf(IOException.class);
    assertThat(inBefore.read()).isEqualTo(-1);
    inBefore.close(); // must not close the new one
    cable.output().write(0x23);
    CompletableFuture<byte[]> host = read(cable.input());
    cable.exchange(0, handedOver::writeBytes);
    cable.disconnect();
    assertThat(host.get(20, TimeUnit.SECONDS)).hasSize(GREETING + 1);
  }

  @Test
  void exchange_wrongByte_hostHasSeenTheEndWhenItReturns() throws Exception {
    cable.connect();
    CompletableFuture<byte[]> host = read(cable.input());
    cable.exchange(0, handedOver::writeBytes);
    cable.output().write(0xFF);
    cable.exchange(1_000, handedOver::writeBytes);
    assertThat(host.get(20, TimeUnit.SECONDS)).hasSize(GREETING);
    cable.exchange(2_000, handedOver::writeBytes); // nobody reads any more: returns all the same
  }
}
