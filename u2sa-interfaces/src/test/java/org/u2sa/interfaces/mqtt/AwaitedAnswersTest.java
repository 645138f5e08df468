package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Which answer of the broker's is whose. */
class AwaitedAnswersTest {
  private static final int PACKETS = 65_535;

  private final AwaitedAnswers awaited = new AwaitedAnswers();

  @Test
  void publishing_allNumbersGoneRound_skipsThoseThatAwaitAnAnswer() {
    CompletableFuture<byte[]> answer = new CompletableFuture<>();
    int question = awaited.asking(answer);
    int unconfirmed = awaited.publishing(null);
    Set<Integer> numbers = new HashSet<>();
    for (int i = 0; i < 2 * PACKETS; i++) {
      int packet = awaited.publishing(null);
      numbers.add(packet);
      awaited.answered(packet, new byte[0]);
    }

    assertThat(numbers).hasSize(PACKETS - 2).doesNotContain(0, question, unconfirmed);
    assertThat(answer).isNotDone();
    assertThat(awaited.unconfirmed()).isEqualTo(1);
  }

  @Test
  void answered_message_confirmsItOnce() {
    AtomicInteger confirmed = new AtomicInteger();
    int packet = awaited.publishing(confirmed::incrementAndGet);
    awaited.answered(packet, new byte[0]);
    awaited.answered(packet, new byte[0]);

    assertThat(confirmed).hasValue(1);
    assertThat(awaited.unconfirmed()).isZero();
  }

  @Test
  void answered_question_givesTheCodes() {
    CompletableFuture<byte[]> answer = new CompletableFuture<>();
    CompletableFuture<byte[]> other = new CompletableFuture<>();
    byte[] codes = {1};
    int packet = awaited.asking(answer);
    awaited.asking(other);
    awaited.answered(packet, codes);

    assertThat(answer).isCompletedWithValue(codes);
    assertThat(other).isNotDone();
  }

  @Test
  void forget_answerComesAfterwards_isNobodys() {
    AtomicInteger confirmed = new AtomicInteger();
    CompletableFuture<byte[]> answer = new CompletableFuture<>();
    int message = awaited.publishing(confirmed::incrementAndGet);
    int question = awaited.asking(answer);
    awaited.forget(message);
    awaited.forget(question);
    awaited.answered(message, new byte[0]);
    awaited.answered(question, new byte[0]);

    assertThat(confirmed).hasValue(0);
    assertThat(answer).isNotDone();
  }

  @Test
  void isFull_manyUnconfirmed_untilOneIs() {
    int first = awaited.publishing(null);
    while (!awaited.isFull()) {
      awaited.publishing(null);
    }
    assertThat(awaited.unconfirmed()).isEqualTo(4_096);
    awaited.answered(first, new byte[0]);

    assertThat(awaited.isFull()).isFalse();
  }

  @Test
  void fail_question_failsAndPublishersAreStillOwed() {
    CompletableFuture<byte[]> answer = new CompletableFuture<>();
    awaited.asking(answer);
    awaited.publishing(null);
    awaited.fail(new IOException("cut"));

    assertThat(answer).isCompletedExceptionally();
    assertThat(awaited.unconfirmed()).isEqualTo(1);
  }
}
