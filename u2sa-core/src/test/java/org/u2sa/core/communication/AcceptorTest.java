package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.channel.embedded.EmbeddedChannel;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the listening socket does while the process has no file descriptor left. */
class AcceptorTest {
  private final PacketPipeline client = new PacketPipeline();
  private final EmbeddedChannel listening =
      new EmbeddedChannel(client.filter.acceptor(new InetSocketAddress("127.0.0.1", 1_883)));

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

  /** Connections with an address, as the listening socket gives them. */
  private int accepted(int connections) {
    return accepted(listening, connections);
  }

  private static int accepted(EmbeddedChannel listening, int connections) {
    int accepted = 0;
    for (int i = 0; i < connections; i++) {
      EmbeddedChannel child =
          new EmbeddedChannel() {
            @Override
            protected SocketAddress remoteAddress0() {
              return new InetSocketAddress("192.0.2.1", 1);
            }
          };
      listening.pipeline().fireChannelRead(child);
      accepted += child.isOpen() ? 1 : 0;
      child.unsafe().closeForcibly();
      child.close();
    }
    return accepted;
  }

  @Test
  void channelRead_moreASecondThanAreAccepted_refusesBeforeAnythingIsBuilt() {
    int most = (int) ConnectionFilter.ACCEPTED_PER_S / 2;
    assertThat(accepted(most)).isEqualTo(most);
    assertThat(accepted(50)).isZero();
    assertThat(client.log)
        .anyMatch(line -> line.contains("connection refused, too many per second"));
    assertThat(listening.config().isAutoRead()).isTrue();

    client.pass(100);
    assertThat(accepted(most)).isEqualTo(most / 10);
  }

  @Test
  void channelRead_moreAtTheWebPort_areRefusedAndLeaveTheMqttPortItsRate() {
    client.filter.serve(WebPortTest.web(8_080, false));
    EmbeddedChannel web =
        new EmbeddedChannel(client.filter.acceptor(new InetSocketAddress("127.0.0.1", 8_080)));
    int most = (int) ConnectionFilter.WEB_ACCEPTED_PER_S / 2;
    assertThat(accepted(web, 2 * most)).isEqualTo(most);

    int mqtt = (int) ConnectionFilter.ACCEPTED_PER_S / 2;
    assertThat(accepted(mqtt)).isEqualTo(mqtt);
    web.finishAndReleaseAll();
  }

  @Test
  void channelRead_moreASecondThanItCanRefuse_letsThemWait() {
    listening.freezeTime();
    accepted((int) ConnectionFilter.ACCEPTED_PER_S);
    assertThat(listening.config().isAutoRead()).isFalse();

    client.pass(100);
    listening.advanceTimeBy(10, TimeUnit.MILLISECONDS);
    listening.runScheduledPendingTasks();
    assertThat(listening.config().isAutoRead()).isTrue();
  }
}
