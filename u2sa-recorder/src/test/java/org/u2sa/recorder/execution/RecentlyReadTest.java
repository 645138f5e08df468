package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.recorder.mcap.record.McapMessage;

class RecentlyReadTest {
  private static McapMessage message(int channel, long sequence, int bytes) {
    return new McapMessage(channel, sequence, 0, 0, new byte[bytes]);
  }

  @Test
  void add_moreThanTheLimit_forgetsTheOldest() {
    RecentlyRead recent = new RecentlyRead(3, 1_000);
    for (int i = 0; i < 4; i++) {
      recent.add(message(1, i, 10));
    }
    assertThat(recent.message(1, 0)).isNull();
    assertThat(recent.message(1, 1).sequence()).isEqualTo(1);
    assertThat(recent.message(1, 3).sequence()).isEqualTo(3);
    assertThat(recent.message(2, 3)).as("of another channel").isNull();
  }

  @Test
  void add_moreBytesThanTheLimit_forgetsTheOldest() {
    RecentlyRead recent = new RecentlyRead(100, 1_000);
    for (int i = 0; i < 10; i++) {
      recent.add(message(1, i, 300));
    }
    assertThat(recent.message(1, 6)).isNull();
    assertThat(recent.message(1, 7)).isNotNull();
    recent.add(message(1, 10, 1_001));
    assertThat(recent.message(1, 10)).as("longer than all may be").isNull();
    recent.add(message(1, 11, 1_000));
    assertThat(recent.message(1, 11)).isNotNull();
  }

  @Test
  void add_sameNumberAgainAndAgain_countsOnce() {
    RecentlyRead recent = new RecentlyRead(100, 1_000);
    recent.add(message(2, 0, 500));
    for (int i = 0; i < 50; i++) {
      recent.add(message(1, 0, 500));
    }
    assertThat(recent.message(1, 0)).isNotNull();
    assertThat(recent.message(2, 0)).isNotNull();
    recent.add(message(3, 0, 1));
    assertThat(recent.message(2, 0)).isNull();
    for (int i = 0; i < 200; i++) {
      recent.add(message(4, i, 900));
    }
    assertThat(recent.message(4, 199)).isNotNull();
  }
}
