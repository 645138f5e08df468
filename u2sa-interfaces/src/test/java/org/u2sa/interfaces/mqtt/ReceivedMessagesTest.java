package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Which topics are remembered when others invent them. */
class ReceivedMessagesTest {
  private static final int MAX_TOPICS = 4_096;

  private final ReceivedMessages received = new ReceivedMessages();

  @Test
  void put_topicsByTheThousand_remembersThoseHeardLast() {
    byte[] payload = {1};
    received.put("real", payload);
    for (int i = 0; i < 2 * MAX_TOPICS; i++) {
      received.put("invented " + i, payload);
      assertThat(received.put("real", payload)).isSameAs(payload);
    }

    assertThat(received.topics()).hasSize(MAX_TOPICS).contains("real", "invented 8191");
    assertThat(received.put("invented 0", payload)).isNull();
  }

  @Test
  void put_longMessages_remembersSomeMegabytes() {
    long most = Math.max(2L << 20, Runtime.getRuntime().maxMemory() / 64);
    int some = (int) (most >> 20);
    for (int i = 0; i < some + 5; i++) {
      received.put("invented " + i, new byte[1 << 20]);
    }
    assertThat(received.topics()).hasSize(some);

    received.forget(topic -> topic.equals("invented " + (some + 4)));
    received.put("short", new byte[1 << 20]);
    assertThat(received.topics()).hasSize(some).contains("short");
  }

  @Test
  void put_oneLongerThanAllMayBe_isRememberedAlone() {
    received.put("a", new byte[1]);
    received.put(
        "b", new byte[(int) Math.max(2L << 20, Runtime.getRuntime().maxMemory() / 64) + 1]);

    assertThat(received.topics()).containsExactly("b");
  }
}
