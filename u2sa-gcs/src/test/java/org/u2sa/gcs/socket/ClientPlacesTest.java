package org.u2sa.gcs.socket;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.channel.embedded.EmbeddedChannel;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class ClientPlacesTest {
  private static final long NO_TASK = -1;

  private final ClientPlaces places = new ClientPlaces(1);
  private final EmbeddedChannel channel = new EmbeddedChannel();

  @Test
  void connected_closesAtOnce_noTimeLimitKeepsItInMemory() {
    places.connected(channel);

    channel.close();

    assertThat(channel.runScheduledPendingTasks()).isEqualTo(NO_TASK);
  }

  @Test
  void connected_anotherOneComes_theDisplacedOneLeavesNothingBehind() {
    places.connected(channel);

    places.connected(new EmbeddedChannel());

    assertThat(channel.isOpen()).isFalse();
    assertThat(channel.runScheduledPendingTasks()).isEqualTo(NO_TASK);
  }

  @Test
  void connected_saysNothing_isClosedAfterTenSeconds() {
    places.connected(channel);
    channel.freezeTime();
    channel.advanceTimeBy(11, TimeUnit.SECONDS);

    channel.runScheduledPendingTasks();

    assertThat(channel.isOpen()).isFalse();
  }
}
