package org.u2sa.gcs.view;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ViewChannelsTest {
  private final ViewChannels channels = new ViewChannels(1_000);

  private ViewChannel channel(int number) {
    return channels.add("topic " + number, ViewChannel.JSON, "Schema", new byte[0], true);
  }

  @Test
  void keep_moreBytesThanTheLimit_forgetsTheOldestMessages() {
    for (int i = 1; i <= 5; i++) {
      channels.keep(channel(i), i, new byte[250]);
    }
    assertThat(channels.last(1)).isEmpty();
    for (int i = 2; i <= 5; i++) {
      assertThat(channels.last(i)).isPresent();
    }
  }

  @Test
  void keep_anotherMessageOfAChannel_countsInPlaceOfTheOneBefore() {
    ViewChannel first = channel(1);
    ViewChannel second = channel(2);
    channels.keep(first, 0, new byte[500]);
    for (int i = 1; i < 100; i++) {
      channels.keep(second, i, new byte[500]);
    }
    assertThat(channels.last(1)).isPresent();
    assertThat(channels.last(2)).map(ViewChannels.Last::nanos).contains(99L);

    channels.keep(first, 100, new byte[400]);
    channels.keep(second, 101, new byte[600]);
    assertThat(channels.last(1)).isPresent();
    channels.keep(first, 102, new byte[401]);
    assertThat(channels.last(1)).isPresent();
    assertThat(channels.last(2)).as("older").isEmpty();
  }

  @Test
  void keep_oneLongerThanTheLimit_isNotKept() {
    channels.keep(channel(1), 0, new byte[1_001]);
    assertThat(channels.last(1)).isEmpty();
    channels.keep(channel(2), 0, new byte[1_000]);
    assertThat(channels.last(2)).isPresent();
  }
}
