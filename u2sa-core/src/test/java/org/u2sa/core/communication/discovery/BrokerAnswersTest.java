package org.u2sa.core.communication.discovery;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.discovery.DnsMessage.Question;

class BrokerAnswersTest {
  private static final AnnouncedBroker BROKER =
      new AnnouncedBroker(
          "x".repeat(64), InetAddress.getLoopbackAddress(), 1883, true, "id-0000001");

  private final BrokerAnswers answers = new BrokerAnswers();

  private static DnsMessage of(DnsRecord... records) {
    return new DnsMessage(List.of(), List.of(records));
  }

  @Test
  void found_announcementOfOneBroker_isIt() {
    answers.take(BROKER.announcement());

    assertThat(answers.found())
        .containsExactly(new FoundBroker("127.0.0.1", 1883, Set.of("x".repeat(64)), true));
  }

  @Test
  void questions_pointerOnly_askForWhatIsMissingUntilItIsFound() {
    List<DnsRecord> records = BROKER.announcement().records();
    answers.take(of(records.get(0)));

    assertThat(answers.found()).isEmpty();
    assertThat(answers.questions().questions()).hasSize(3);
    for (int i = 0; i < 3; i++) { // an answer to each question, as other responders give it
      for (Question question : answers.questions().questions()) {
        records.stream().filter(question::asksFor).forEach(record -> answers.take(of(record)));
      }
    }
    assertThat(answers.found()).hasSize(1);
    assertThat(answers.questions().questions()).hasSize(1);
  }

  @Test
  void take_goodbye_isNoAnswer() {
    assertThat(answers.take(BROKER.goodbye())).isFalse();
  }

  @Test
  void take_tenThousandInventedBrokers_keepsSixtyFour() {
    for (int i = 0; i < 10_000; i++) {
      String id = String.format("%08d-invented", i);
      answers.take(
          new AnnouncedBroker("boat", InetAddress.getLoopbackAddress(), 1883, false, id)
              .announcement());
    }

    assertThat(answers.found()).hasSize(64);
  }

  @Test
  void take_recordsOfNobodysHost_areNotKept() {
    DnsRecord stranger =
        DnsRecord.address(List.of("host", "local"), 120, InetAddress.getLoopbackAddress());

    assertThat(answers.take(of(stranger))).isFalse();
  }

  @Test
  void isAskedForBy_typeInstanceAndOthers_answersItsOwnOnly() {
    List<String> instance = BROKER.announcement().records().get(2).name();

    assertThat(isAsked(AnnouncedBroker.TYPE, DnsRecord.POINTER)).isTrue();
    assertThat(isAsked(instance, 255)).as("any").isTrue();
    assertThat(isAsked(AnnouncedBroker.TYPE, DnsRecord.SERVICE)).isFalse();
    assertThat(isAsked(List.of("_http", "_tcp", "local"), DnsRecord.POINTER)).isFalse();
    assertThat(instance.get(0)).hasSizeLessThan(64);
  }

  private static boolean isAsked(List<String> name, int type) {
    return BROKER.isAskedForBy(new DnsMessage(List.of(new Question(name, type)), List.of()));
  }
}
