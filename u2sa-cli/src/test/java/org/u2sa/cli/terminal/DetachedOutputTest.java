package org.u2sa.cli.terminal;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;

/** No thread of a running vehicle waits for a terminal that takes no output. */
@Timeout(120)
class DetachedOutputTest {
  private static final long FOREVER_MS = 100_000;

  private final CountDownLatch reached = new CountDownLatch(1);
  private final CountDownLatch released = new CountDownLatch(1);
  private final StringBuffer shown = new StringBuffer();

  /** Takes no output until released, such as after Ctrl-S. */
  private final OutputStream held =
      new OutputStream() {
        @Override
        public void write(int oneByte) {
          throw new UnsupportedOperationException("writes come in whole");
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
          reached.countDown();
          try {
            released.await();
          } catch (InterruptedException e) {
            throw new IOException(e);
          }
          shown.append(new String(bytes, offset, length, UTF_8));
        }
      };

  @AfterEach
  void release() {
    released.countDown();
  }

  private static void write(DetachedOutput output, String text) throws IOException {
    output.write(text.getBytes(UTF_8));
  }

  @Test
  void write_detachedAndHeld_returnsAndIsShownOnRelease() throws IOException {
    DetachedOutput output = new DetachedOutput(held, FOREVER_MS);
    output.detach();
    write(output, "a\n");
    write(output, "b\n");
    assertThat(shown).isEmpty();

    released.countDown();
    output.attach();
    assertThat(shown).hasToString("a\nb\n");
  }

  @Test
  void write_detachedAndHeldForLong_dropsAndSaysHowMany() throws Exception {
    DetachedOutput output = new DetachedOutput(held, FOREVER_MS);
    String line = "x".repeat(1_023) + "\n";
    output.detach();
    write(output, line);
    reached.await(); // this line no longer waits in the queue
    int queued = DetachedOutput.MAX_WAITING_BYTES / line.length();
    for (int k = 0; k < 2 * queued; k++) {
      write(output, line);
    }
    released.countDown();
    output.attach();

    assertThat(shown)
        .hasToString(
            line.repeat(1 + queued)
                + "u2sa: lines not printed because the output was blocked: "
                + queued
                + "\n");
  }

  @Test
  void attach_outputTakesNothing_givesUpAndStillDoesNotWait() throws IOException {
    DetachedOutput output = new DetachedOutput(held, 1);
    output.detach();
    write(output, "a\n");
    output.attach();
    write(output, "b\n");
    assertThat(shown).isEmpty();

    released.countDown();
    while (shown.length() < 4) {
      Thread.onSpinWait();
    }
    assertThat(shown).hasToString("a\nb\n");
  }

  @Test
  void write_attached_passesThrough() throws IOException {
    released.countDown();
    DetachedOutput output = new DetachedOutput(held, FOREVER_MS);
    output.detach();
    write(output, "a\n");
    output.attach();
    write(output, "b\n");

    assertThat(shown).hasToString("a\nb\n");
  }

  @Test
  void write_attachedToAClosedPipe_fails() {
    DetachedOutput output =
        new DetachedOutput(
            new OutputStream() {
              @Override
              public void write(int oneByte) throws IOException {
                throw new IOException("Broken pipe");
              }
            },
            FOREVER_MS);

    assertThatThrownBy(() -> write(output, "a")).hasMessage("Broken pipe");
    output.detach();
    assertThat(new PrintStream(output).checkError()).isFalse();
    output.attach();
  }

  @Test
  @SuppressWarnings("try") // resources used only for closing
  void detach_ofACommandsOutput_detachesInRealTimeOnly() throws IOException {
    DetachedOutput out = new DetachedOutput(held, FOREVER_MS);
    Console console = new Console(out, new DetachedOutput(held, 1));
    PlainLines lines =
        new PlainLines(
            new PrintWriter(new PrintStream(out, true, UTF_8), true), Optional.of(console));
    try (Console.Detached detached = PlainLines.detach(lines, new SystemClock())) {
      lines.println("status");
      assertThat(shown).isEmpty();
      released.countDown();
    }
    try (Console.Detached detached = PlainLines.detach(lines, new LockstepClock())) {
      lines.println("report");
      assertThat(shown).hasToString("status\nreport\n"); // written before println returned
    }
  }
}
