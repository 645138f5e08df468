package org.u2sa.core.communication.routing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.configuration.XmlConfiguration;

class RetainedTableTest {
  private final RetainedTable table =
      new RetainedTable(
          XmlConfiguration.inMemory(
                  "test",
                  Map.of(
                      "MAX RETAINED TOPICS", 16,
                      "MAX RETAINED BYTES", 65_536,
                      "MAX CLIENT RETAINED BYTES", 40_000))
              .settings(BrokerLimits.class)
              .get());

  private boolean enters(String topic, String owner, int bytes) {
    return table.enter(topic, owner, new byte[bytes], false).isEmpty();
  }

  @Test
  void enter_moreTopicsThanThereMayBe_isRefusedWhoeverAsks() {
    for (int i = 0; i < 8; i++) {
      assertThat(enters("a" + i, "ann", 1)).isTrue();
      assertThat(enters("b" + i, "bob", 1)).isTrue();
    }
    assertThat(table.enter("c", "cid", new byte[1], false)).hasValue("too many retained topics");
    assertThat(enters("a1", "ann", 2)).as("one that is there already").isTrue();
    assertThat(table.topics()).hasSize(16).doesNotContain("c");
  }

  @Test
  void enter_moreTopicsOfOneThanHalf_isRefused() {
    for (int i = 0; i < 8; i++) {
      assertThat(enters("a" + i, "ann", 1)).isTrue();
    }
    assertThat(table.enter("a8", "ann", new byte[1], false))
        .hasValue("too many retained topics of one client");
    assertThat(enters("b", "bob", 1)).isTrue();
  }

  @Test
  void enter_moreBytesThanThereMayBe_isRefusedAndWhatWasThereStays() {
    assertThat(enters("a", "ann", 40_000)).isTrue();
    assertThat(table.enter("a2", "ann", new byte[1], false))
        .hasValue("too many retained bytes of one client");
    assertThat(table.enter("b", "bob", new byte[30_000], false))
        .hasValue("too many retained bytes");
    assertThat(enters("b", "bob", 25_536)).isTrue();
    assertThat(table.enter("a", "ann", new byte[40_001], false)).isPresent();
    assertThat(table.topics()).containsExactlyInAnyOrder("a", "b");
    assertThat(enters("a", "ann", 0)).as("deleting").isTrue();
    assertThat(enters("b", "bob", 40_000)).isTrue();
    assertThat(table.topics()).containsExactly("b");
  }

  @Test
  void enter_urgentIntoAFullTable_hasRoomOfItsOwn() {
    for (int i = 0; i < 8; i++) {
      enters("a" + i, "ann", 4_000);
      enters("b" + i, "bob", 4_000);
    }
    assertThat(enters("c", "pilot", 1)).isFalse();

    assertThat(table.enter("stop", "pilot", new byte[10_000], true)).isEmpty();
    assertThat(table.enter("huge stop", "pilot", new byte[20_000], true)).isPresent();
    for (int i = 0; table.enter("stop" + i, "ann", new byte[1], true).isEmpty(); i++) {
      assertThat(i).as("urgent topics").isLessThan(1_000);
    }
  }

  @Test
  void enterLocal_ofThisProcess_takesNobodysRoom() {
    for (int i = 0; i < 100; i++) {
      table.enterLocal("local" + i, new byte[1_000_000]);
    }
    assertThat(enters("local1", "ann", 40_000)).isTrue();
    assertThat(enters("a", "ann", 1)).isFalse();
    table.enterLocal("local1", new byte[1]);
    assertThat(enters("a", "ann", 40_000)).isTrue();
  }

  @Test
  void enter_urgentAgainAndDeleted_countsOnce() {
    for (int i = 0; i < 1_000; i++) {
      assertThat(table.enter("stop", "pilot", new byte[16_384], true)).isEmpty();
    }
    assertThat(table.enter("stop", "pilot", new byte[16_385], true))
        .hasValue("too much urgent is retained");
    for (int i = 0; i < 255; i++) {
      assertThat(table.enter("stop" + i, "pilot", new byte[1], true)).isEmpty();
    }
    assertThat(table.enter("another", "pilot", new byte[1], true)).isPresent();
    assertThat(table.enter("stop7", "pilot", new byte[0], true)).as("deleting").isEmpty();
    assertThat(table.enter("another", "pilot", new byte[1], true)).isEmpty();
    assertThat(enters("report", "pilot", 40_000)).as("what is not urgent has its own").isTrue();
  }

  @Test
  void enter_ofWhoHasDeletedAll_startsAnew() {
    for (int round = 0; round < 3; round++) {
      for (int i = 0; i < 8; i++) {
        assertThat(enters("a" + i, "ann", 5_000)).isTrue();
      }
      assertThat(enters("a8", "ann", 1)).isFalse();
      for (int i = 0; i < 8; i++) {
        assertThat(enters("a" + i, "ann", 0)).isTrue();
      }
      assertThat(table.topics()).isEmpty();
    }
  }
}
