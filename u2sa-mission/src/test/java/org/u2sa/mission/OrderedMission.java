package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;

/** A mission that operators order to change. */
abstract class OrderedMission extends ThreeWaypoints {
  int orders;

  static MissionOrder order(MissionAction action) {
    return new MissionOrder().action(action).operator("anna");
  }

  static MissionOrder goals(MissionAction action, String goals) {
    return order(action).file("more.xml").goals("<mission>\n" + goals + "\n</mission>");
  }

  MissionOrderResult give(MissionOrder order) {
    if (!order.isFrozen()) {
      order.requestId("order " + ++orders);
    }
    kit.publish(Channels.MISSION, order);
    MissionOrderResult result = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(result.requestId()).isEqualTo(order.requestId());
    return result;
  }

  void accepted(MissionOrder order, String outcome) {
    MissionOrderResult result = give(order);
    assertThat(result.outcome()).isEqualTo(outcome);
    assertThat(result.accepted()).isTrue();
  }

  void refused(MissionOrder order, String why) {
    List<String> before = current();
    MissionOrderResult result = give(order);
    assertThat(result.outcome()).isEqualTo(why);
    assertThat(result.accepted()).isFalse();
    assertThat(current()).isEqualTo(before);
  }

  MissionReport report() {
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    return (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
  }

  void run(String... uids) {
    for (String uid : uids) {
      assertThat(current()).containsExactly(uid);
      complete(uid);
    }
  }
}
