package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.safety.FailsafeState;

/** Which retained message is news, as long as no session is made again. */
class RetainedNewsTest {
  private static final String TOPIC =
      Topic.of("cessna", Channels.FAILSAFE, FailsafeState.TYPE).toString();
  private static final byte[] ONE = {1};

  private final List<String> refused = new ArrayList<>();
  private final RetainedTopics topics = new RetainedTopics(refused::add);

  @Test
  void isNews_sameTextAgainInOneSession_isNewsEachTime() {
    assertThat(topics.isNews(TOPIC, ONE)).isTrue();
    assertThat(topics.isNews(TOPIC, ONE.clone())).isTrue();
  }

  @Test
  void publishing_topic_remembersAndRefusesNothing() {
    assertThat(topics.publishing(TOPIC, ONE)).isNotSameAs(topics.publishing(TOPIC, ONE));
    assertThat(refused).isEmpty();
  }
}
