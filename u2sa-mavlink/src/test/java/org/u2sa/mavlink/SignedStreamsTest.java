package org.u2sa.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Streams that one system opens with ever new link IDs. */
class SignedStreamsTest {
  private static final long NOW = 1L << 45;
  private static final long MINUTE = 6_000_000;

  private final SignedStreams streams = new SignedStreams(NOW);

  private String admit(int system, int link, long time, long now) {
    return streams.refusal(system << 16 | 190 << 8 | link, time, now);
  }

  @Test
  void refusal_moreStreamsOfASystemThanKept_isForThatSystemOnlyAndForAMinute() {
    for (int link = 0; link < 64; link++) {
      assertThat(admit(200, link, NOW, NOW)).isEmpty();
    }
    assertThat(admit(200, 64, NOW, NOW)).isEqualTo("more than 64 signed streams of one system");
    assertThat(admit(254, 0, NOW, NOW)).isEmpty();
    long later = NOW + MINUTE + 1;
    assertThat(admit(200, 64, later, later)).isEmpty();
    assertThat(admit(200, 1, NOW, later))
        .isEqualTo("outdated signature of a new stream"); // forgotten, not admitted
  }
}
