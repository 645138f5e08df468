package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.ByteBuf;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.util.concurrent.EventExecutor;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.TimeShare;
import org.u2sa.core.communication.routing.Publication;
import org.u2sa.core.communication.routing.TopicRoute;

/** What clients without a log-in get of the network thread's time. */
class AnonymousOutputTest {
  private static final int TAKES_MICROS = 1_000; // a message

  private long nowMicros;
  private final EmbeddedChannel channel = new EmbeddedChannel();
  private final EventExecutor network = channel.eventLoop();
  private final List<Integer> delivered = new ArrayList<>();
  private final List<String> dropped = new ArrayList<>();
  private final AnonymousOutput output =
      new AnonymousOutput(new TimeShare(0.1, 0.005, () -> nowMicros), dropped::add);

  private final AnonymousOutput.Recipient listener =
      new AnonymousOutput.Recipient() {
        @Override
        public String label() {
          return "listener";
        }

        @Override
        public boolean deliverNow(Publication publication, boolean eachMatters) {
          nowMicros += TAKES_MICROS;
          ByteBuf packet = publication.packet(channel.alloc());
          delivered.add(packet.getInt(packet.writerIndex() - Integer.BYTES));
          packet.release();
          return false;
        }
      };

  @AfterEach
  void close() {
    channel.finishAndReleaseAll();
  }

  private void publish(int from, int to) {
    for (int i = from; i < to; i++) {
      ByteBuf payload = channel.alloc().ioBuffer().writeInt(i);
      Publication publication =
          new Publication(new TopicRoute("u2sa/boat/state/S"), payload, false);
      output.add(listener, publication, true, network);
      publication.release();
      payload.release(); // as the decoder does after each message
    }
  }

  private void pass(int milliseconds) {
    for (int passed = 0; passed < milliseconds; passed++) {
      nowMicros += 1_000;
      channel.advanceTimeBy(1, TimeUnit.MILLISECONDS);
      channel.runScheduledPendingTasks();
    }
  }

  @Test
  void add_littleTraffic_isSentAtOnce() {
    publish(0, 3);
    assertThat(delivered).containsExactly(0, 1, 2);
  }

  @Test
  void add_moreThanTheirTime_waitsAndComesInOrder() {
    publish(0, 50);
    assertThat(delivered).hasSizeBetween(5, 7);
    pass(100);
    assertThat(delivered).hasSizeBetween(13, 18);

    pass(1_000);
    assertThat(delivered).hasSize(50).isSorted();
    assertThat(dropped).isEmpty();
  }

  @Test
  void add_moreThanMayWait_dropsTheOldestAndCountsThem() {
    int all = AnonymousOutput.MAX_WAITING + 1_000;
    publish(0, all);
    int sent = delivered.size();
    assertThat(dropped).hasSize(all - sent - AnonymousOutput.MAX_WAITING).containsOnly("listener");
    pass(20);
    assertThat(delivered.get(sent)).isEqualTo(all - AnonymousOutput.MAX_WAITING);
  }
}
