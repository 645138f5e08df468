package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.channel.embedded.EmbeddedChannel;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the listening socket does while the process has no file descriptor left. */
class AcceptorTest {
  private final PacketPipeline client = new PacketPipeline();
  private final EmbeddedChannel listening = new EmbeddedChannel(client.filter.new Acceptor());

  @AfterEach
  void close() {
    client.close();
    listening.finishAndReleaseAll();
  }

  private void fail() {
    listening.pipeline().fireExceptionCaught(new IOException("Too many open files"));
  }

  @Test
  void exceptionCaught_noFileDescriptorLeft_acceptsAgainSoon() {
    listening.freezeTime();
    fail();
    assertThat(listening.config().isAutoRead()).isFalse();

    listening.advanceTimeBy(199, TimeUnit.MILLISECONDS);
    listening.runScheduledPendingTasks();
    assertThat(listening.config().isAutoRead()).isFalse();
    listening.advanceTimeBy(1, TimeUnit.MILLISECONDS);
    listening.runScheduledPendingTasks();
    assertThat(listening.config().isAutoRead()).isTrue();
    listening.checkException(); // none reached the end, where Netty prints each
  }

  @Test
  void exceptionCaught_againAndAgain_isLoggedAtPowersOfTwo() {
    for (int i = 0; i < 1_000; i++) {
      fail();
    }
    assertThat(client.log)
        .hasSize(10)
        .allMatch(line -> line.startsWith("connection not accepted: \"Too many open files\""));
  }
}
