package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** When to ask a broker whether it lives, and when to give it up: keep-alive of 10 s. */
class LinkCheckTest {
  private static final long SECOND = 1_000_000;

  private long now = 1_000 * SECOND;
  private final long began = now;
  private final LinkCheck link = new LinkCheck(() -> now, 10 * SECOND);

  private void pass(double seconds) {
    now += (long) (seconds * SECOND);
  }

  @Test
  void isToAsk_halfTheKeepAliveWithoutAWord_once() throws IOException {
    pass(4.999);
    assertThat(link.isToAsk(now)).isFalse();
    assertThat(link.waitMs(now)).isEqualTo(1);

    pass(0.001);
    assertThat(link.isToAsk(now)).isTrue();
    assertThat(link.isToAsk(now)).isFalse();
  }

  @Test
  void isToAsk_nothingSentThoughMuchHeard_asksToo() throws IOException {
    pass(4.0);
    link.heard();
    pass(1.0);

    assertThat(link.isToAsk(now)).isFalse();
    assertThat(link.isToAsk(began)).isTrue(); // or the broker ends it
  }

  @Test
  void isToAsk_noAnswer_failsAfterTwiceTheKeepAlive() throws IOException {
    pass(5.0);
    link.isToAsk(began);
    pass(14.999);
    assertThat(link.isToAsk(began)).isFalse();
    assertThat(link.waitMs(began)).isEqualTo(1);

    pass(0.001);
    assertThatThrownBy(() -> link.isToAsk(began))
        .isInstanceOf(IOException.class)
        .hasMessage("the broker does not answer");
  }

  @Test
  void heard_afterAsking_startsAnew() throws IOException {
    pass(5.0);
    link.isToAsk(now);
    pass(14.0);
    link.heard();
    pass(1.0);

    assertThat(link.isToAsk(now)).isFalse();
    assertThat(link.waitMs(now)).isEqualTo(4_000);
  }

  @Test
  void waitMs_notOpenYet_longerThanAnybodyWaitsForTheAnswer() {
    assertThat(link.waitMs()).isEqualTo(15_000);
  }
}
