package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the contract cannot see: what waits between the device and the owner. */
class ReconnectingLinkTest {
  private static final String LOSS = "loss";

  private final BlockingQueue<String> said = new LinkedBlockingQueue<>();
  private final BlockingQueue<Boolean> isThere = new LinkedBlockingQueue<>();
  private volatile int readings;
  private final ReconnectingLink link = new ReconnectingLink("the test", this::open, 0.0);

  private Port open() throws IOException {
    if (isThere.poll() == null) {
      throw new IOException("not there");
    }
    return new Port() {
      @Override
      public int read(byte[] buffer) throws IOException {
        String next = next();
        if (next == null) {
          return 0;
        }
        if (next.equals(LOSS)) {
          throw new IOException("unplugged");
        }
        byte[] bytes = next.getBytes(US_ASCII);
        System.arraycopy(bytes, 0, buffer, 0, bytes.length);
        return bytes.length;
      }

      private String next() throws IOException {
        readings++;
        try {
          return said.poll(10, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new IOException("interrupted", e);
        }
      }

      @Override
      public void write(byte[] bytes) {}

      @Override
      public void close() {}
    };
  }

  @AfterEach
  void close() {
    link.close();
  }

  private static ConditionFactory soon() {
    return await().atMost(Duration.ofSeconds(30)).pollInterval(Duration.ofMillis(10));
  }

  /** Until all that was said is with the link: it asks the device for more. */
  private void untilTaken() {
    soon().until(said::isEmpty);
    int before = readings;
    soon().until(() -> readings > before + 1);
  }

  private String heard() {
    byte[] buffer = new byte[64];
    return new String(buffer, 0, link.read(buffer), US_ASCII);
  }

  @Test
  void read_bytesOfBeforeTheLossNotReadYet_areDropped() {
    isThere.add(true);
    said.add("old");
    soon().until(link::isConnected);
    untilTaken();
    said.add(LOSS);
    soon().until(() -> !link.isConnected());
    assertThat(link.trouble()).isEqualTo("unplugged");
    isThere.add(true);
    said.add("new");
    soon().until(link::isConnected);
    untilTaken();

    assertThat(link.connections()).isEqualTo(2);
    assertThat(heard()).isEqualTo("new");
  }

  @Test
  void trouble_deviceNeverThere_saysWhatIsWrong() {
    soon().until(() -> link.trouble().equals("not there"));
    assertThat(link.isConnected()).isFalse();
    assertThat(link.connections()).isZero();
    assertThat(link.write(new byte[1])).isFalse();
  }

  @Test
  void read_nobodyReads_oldestAreDroppedAndItIsSaid() {
    isThere.add(true);
    for (int i = 0; i < 70; i++) {
      said.add("x".repeat(1_000));
    }
    said.add("newest");
    soon().until(link::isConnected);
    untilTaken();

    assertThat(link.trouble())
        .isEqualTo("data arrived faster than it was read: the oldest bytes were dropped");
    link.connections();
    StringBuilder all = new StringBuilder();
    for (String part = heard(); !part.isEmpty(); part = heard()) {
      all.append(part);
    }
    assertThat(all).hasSize(65_536).endsWith("newest");
  }
}
