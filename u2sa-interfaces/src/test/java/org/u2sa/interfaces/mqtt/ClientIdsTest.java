package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** How a client ID tells whose it is, and to whom. */
class ClientIdsTest {
  private static final String RUN = "123e4567-e89b-12d3-a456-426614174000";

  @Test
  void of_twoServices_areOfOneSenderAndDiffer() {
    String planner = ClientIds.of("cessna", "PathPlanner");
    String again = ClientIds.of("cessna", "PathPlanner");

    assertThat(again).isNotEqualTo(planner);
    assertThat(ClientIds.senderOf(planner)).isEqualTo(ClientIds.run());
    assertThat(ClientIds.senderOf(again)).isEqualTo(ClientIds.run());
  }

  @Test
  void shown_doesNotTellTheRun() {
    String id = ClientIds.of("cessna", "PathPlanner");

    assertThat(ClientIds.shown(id))
        .startsWith("cessna/PathPlanner/")
        .doesNotContain(ClientIds.run());
    assertThat(ClientIds.shown("mosquitto_pub")).isEqualTo("mosquitto_pub");
  }

  @Test
  void senderOf_idsOfOthers_areSendersThemselves() {
    assertThat(ClientIds.senderOf("mosquitto_pub")).isEqualTo("mosquitto_pub");
    assertThat(ClientIds.senderOf("cessna/Lidar/" + RUN)).isEqualTo("cessna/Lidar/" + RUN);
    assertThat(ClientIds.senderOf("a/b/c/d")).isEqualTo("a/b/c/d");
    assertThat(ClientIds.senderOf("cessna/Lidar/" + RUN + "/1")).isEqualTo(RUN);
  }

  @Test
  void run_ofAProcessThatAnotherStarted_isTheOthers() {
    assertThat(ClientIds.run(Map.of(ClientIds.ENVIRONMENT, RUN))).isEqualTo(RUN);
    assertThat(ClientIds.run(Map.of())).hasSize(RUN.length()).isNotEqualTo(ClientIds.run(Map.of()));
    assertThat(ClientIds.run(Map.of(ClientIds.ENVIRONMENT, "guessable"))).hasSize(RUN.length());
  }
}
