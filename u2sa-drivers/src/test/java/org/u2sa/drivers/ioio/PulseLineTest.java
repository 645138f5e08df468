package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import ioio.lib.api.PulseInput;
import java.lang.reflect.Proxy;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class PulseLineTest {
  private static final byte REPORT = 0x1C;
  private static final byte INPUT = (byte) 0x82; // 2, two bytes follow
  private static final byte OTHER = 0x0C;

  private final Deque<Float> pulses = new ArrayDeque<>(); // that the library has
  private final PulseLine line = new PulseLine(library());
  private int asked; // times the library was

  private PulseInput library() {
    return (PulseInput)
        Proxy.newProxyInstance(
            getClass().getClassLoader(),
            new Class<?>[] {PulseInput.class},
            (proxy, method, arguments) -> {
              asked++;
              if (pulses.isEmpty()) {
                Thread.interrupted();
                throw new InterruptedException(); // as waiting does on an interrupted thread
              }
              return pulses.remove();
            });
  }

  @AfterEach
  void theThread_isNotInterrupted() {
    assertThat(Thread.interrupted()).isFalse();
  }

  @Test
  void next_bytesAreNotSeen_asksTheLibraryEachTime() throws Exception {
    assertThat(line.next()).isEmpty();
    pulses.addAll(List.of(0.5f, 0.25f));
    assertThat(line.next()).hasValue(0.5);
    assertThat(line.next()).hasValue(0.25);
    assertThat(line.next()).isEmpty();
    assertThat(asked).isEqualTo(4);
  }

  @Test
  void next_bytesTellOfPulses_asksForSoManyOnly() throws Exception {
    line.comes(new byte[] {OTHER, REPORT, INPUT, OTHER, OTHER, REPORT, INPUT});
    pulses.addAll(List.of(0.5f, 0.25f));
    assertThat(line.next()).hasValue(0.5);
    assertThat(line.next()).hasValue(0.25);
    assertThat(line.next()).isEmpty();
    assertThat(asked).isEqualTo(2);
  }

  @Test
  void next_bytesThatOnlyLookLikeReports_asksOnceAndFindsTheNextPulse() throws Exception {
    line.comes(new byte[] {REPORT, INPUT, REPORT, INPUT, REPORT});
    assertThat(line.next()).isEmpty();
    assertThat(line.next()).isEmpty();
    assertThat(asked).isEqualTo(1);

    line.comes(new byte[] {REPORT, INPUT});
    pulses.add(0.5f);
    assertThat(line.next()).hasValue(0.5);
  }

  @Test
  void next_bytesThatCannotBeReports_asksNotAtAll() throws Exception {
    line.comes(new byte[] {REPORT, OTHER, REPORT, (byte) 0x92, REPORT, 0x30});
    assertThat(line.next()).isEmpty();
    assertThat(asked).isZero();
  }

  @Test
  void next_pulsesFromBeforeTheFirstBytes_areTaken() throws Exception {
    pulses.addAll(List.of(0.5f, 0.25f));
    assertThat(line.next()).hasValue(0.5);
    line.comes(new byte[] {REPORT, INPUT});
    assertThat(line.next()).hasValue(0.25);
  }
}
