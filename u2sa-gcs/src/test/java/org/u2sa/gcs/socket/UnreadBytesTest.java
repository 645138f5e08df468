package org.u2sa.gcs.socket;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.channel.WriteBufferWaterMark;
import org.junit.jupiter.api.Test;

/** What clients leave unread fits in the heap, however many there are. */
class UnreadBytesTest {
  @Test
  void buffer_anyNumberOfClients_allTogetherTakeAnEighthOfTheHeap() {
    for (int clients : new int[] {1, 16, 1024, 65_536}) {
      WriteBufferWaterMark buffer = WebSocketServer.buffer(clients);
      assertThat((long) buffer.high() * clients)
          .isLessThanOrEqualTo(Runtime.getRuntime().maxMemory() / 8);
      assertThat(buffer.high()).isBetween(1, 4 << 20);
      assertThat(buffer.low()).isLessThan(buffer.high());
    }
  }
}
