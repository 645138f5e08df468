package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.schema.U2SAData;

/** Orders that arrive late or twice. */
class RepeatedOrdersTest extends OrderedMission {

  @Test
  void skip_thatTheNetworkBringsTwice_isObeyedOnceAndAnsweredTwice() {
    kit.start(MissionManager::new);
    MissionOrder once = order(MissionAction.SKIP);
    assertThat(give(once).accepted()).isTrue();
    int answers = kit.published(Channels.MISSION).size();
    assertThat(give(once).accepted()).isTrue();

    assertThat(kit.published(Channels.MISSION)).hasSize(answers + 1);
    assertThat(current()).containsExactly("2");
  }

  private <T extends U2SAData> T lateBy(double seconds, T message) {
    kit.advance(30.0);
    message.timestamp(kit.clock().micros() - Clock.micros(seconds));
    return message;
  }

  /** As of a program that uses one ID for all. */
  @Test
  void order_idOfAnotherOrder_isExecuted() {
    kit.start(MissionManager::new);
    kit.publish(Channels.MISSION, order(MissionAction.GOTO).uid("3").requestId("x"));
    assertThat(current()).containsExactly("3");
    kit.publish(Channels.MISSION, order(MissionAction.PAUSE).requestId("x"));
    MissionOrderResult paused = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(paused.outcome()).isEqualTo("paused at 3");
    kit.publish(Channels.MISSION, order(MissionAction.RESUME).requestId("x"));
    kit.publish(Channels.MISSION, order(MissionAction.PAUSE).requestId("x"));
    MissionOrderResult again = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(again.outcome()).isEqualTo("paused at 3");
  }

  @Test
  void order_sameOrderGivenAgainUnderItsId_isExecutedAndARepeatIsNot() {
    kit.start(MissionManager::new);
    MissionOrder first = order(MissionAction.GOTO).uid("2").requestId("x");
    kit.publish(Channels.MISSION, first);
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
    kit.publish(Channels.MISSION, first);
    assertThat(current()).as("arrives twice").containsExactly("3");

    kit.advance(1.0);
    kit.publish(Channels.MISSION, order(MissionAction.GOTO).uid("2").requestId("x"));
    assertThat(current()).containsExactly("2");
  }

  @Test
  void order_arrivesAgainAtARestartedManager_isAnsweredButNotExecutedAgain() {
    MissionManager before = kit.start(MissionManager::new);
    MissionOrder skip = order(MissionAction.SKIP).requestId("x");
    kit.publish(Channels.MISSION, skip);
    assertThat(current()).containsExactly("2");
    kit.restart(before, MissionManager::new);
    kit.publish(Channels.MISSION, skip);

    assertThat(current()).containsExactly("2");
    MissionOrderResult again = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(again.outcome()).isEqualTo("goal \"1\" skipped; current: 2");
  }

  /** A broker keeps orders while a link is down. */
  @Test
  void order_olderThanItsExpiry_isRefusedUnlessItPauses() {
    kit.start(MissionManager::new);
    refused(
        lateBy(20.0, order(MissionAction.GOTO).uid("3")),
        "the order arrived 20.0 s after it was given; expected at most ORDER EXPIRY, 5 s: give it"
            + " again (if it was given just now, the clocks differ)");
    String id = "order " + orders;
    kit.publish(Channels.MISSION, lateBy(4.0, order(MissionAction.GOTO).uid("3").requestId(id)));
    assertThat(current()).as("given again under its ID").containsExactly("3");
    accepted(lateBy(20.0, order(MissionAction.PAUSE)), "paused at 3");
    MissionOrderResult resumed = give(lateBy(20.0, order(MissionAction.RESUME)));
    assertThat(resumed.accepted()).isFalse();
  }

  @Test
  void goalCommandAndUpdate_olderThanTheirExpiry_haveNoEffect() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_COMMANDS, lateBy(20.0, new GoalCommand().uid("3")));
    kit.publish(
        Channels.GOAL_UPDATES,
        lateBy(20.0, new Waypoint().uid("1").x(77.0).y(1.0).horizontalThreshold(1.0)));

    assertThat(current()).containsExactly("1");
    assertThat(kit.log("MissionManager"))
        .anyMatch(line -> line.contains("command to change to goal \"3\" rejected: the order"))
        .anyMatch(line -> line.contains("update of goal \"1\" refused: the order arrived 20.0 s"));
    kit.publish(Channels.GOAL_COMMANDS, lateBy(4.0, new GoalCommand().uid("3")));
    assertThat(current()).containsExactly("3");
  }
}
