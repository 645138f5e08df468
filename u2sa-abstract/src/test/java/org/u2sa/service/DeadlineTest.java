package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** Data older than its deadline is absent; what is urgent overtakes. */
@Timeout(120)
class DeadlineTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  private static final class Listener extends EventDrivenService {
    private final List<U2SAData> heard = new ArrayList<>();

    Listener(ServiceContext context) {
      super(context, ServiceRole.PATH_PLANNER, "Listener");
      subscribe(Channels.STATE, 1.0, heard::add);
      registerSubscriber(Channels.GOAL_REPORTS);
      registerSubscriber(Channels.EMERGENCY_STOP);
    }

    @Override
    public void callback(U2SAData data) {
      heard.add(data);
    }
  }

  private static StateInformation state(long micros) {
    StateInformation state = new StateInformation().x(1.0);
    state.timestamp(micros);
    return state;
  }

  @Test
  void callback_messageOlderThanItsDeadline_isAbsentCountedAndSaid() {
    Listener listener = kit.start(Listener::new);
    kit.advance(3.0);

    kit.publish(Channels.STATE, state(1_999_999L));
    kit.publish(Channels.STATE, state(2_000_000L));
    kit.advance(0.3);

    assertThat(listener.heard).containsExactly(sent(2_000_000L));
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().expired()).hasValue(1);
    assertThat(kit.log("Listener"))
        .anyMatch(line -> line.contains("state: message 1.001 s old counts as absent"));
  }

  @Test
  void callback_stampedAheadOfThisClock_agesFromItsArrival() {
    Sleeper sleeper = kit.start(Sleeper::new);
    kit.send(Channels.STATE, state(3_600_000_000L)); // its source's clock is an hour ahead
    kit.advance(1.4); // it waits for the next report of health

    assertThat(sleeper.heard).isEmpty();
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().expired()).hasValue(1);
  }

  /** Looks at its messages when it wakes for its health report only. */
  private static final class Sleeper extends PeriodicService {
    private final List<U2SAData> heard = new ArrayList<>();

    Sleeper(ServiceContext context) {
      super(context, ServiceRole.PATH_PLANNER, "Sleeper", 1.5);
      handleMessagesAtSteps();
      registerSubscriber(Channels.STATE, 0.1);
    }

    @Override
    public void callback(U2SAData data) {
      heard.add(data);
    }

    @Override
    protected void step(double nowS) {
      assertThat(nowS).isNotNegative(); // nothing to do at a step
    }
  }

  private static StateInformation sent(long micros) {
    StateInformation state = state(micros);
    state.systemId(ServiceKit.SYSTEM_ID);
    return state;
  }

  @Test
  void callback_emergencyStop_overtakesWhatWaitsAndIsNotKeptOutByAFullInbox() {
    kit.with("INBOX CAPACITY", 1);
    Listener listener = kit.start(Listener::new);
    kit.send(Channels.STATE, state(0L));
    kit.send(Channels.STATE, state(1L));
    kit.send(Channels.GOAL_REPORTS, new Waypoint().uid("1").horizontalThreshold(1.0));
    kit.send(Channels.EMERGENCY_STOP, new EmergencyStop().active(true));
    kit.settle();

    assertThat(listener.heard).hasSize(2);
    assertThat(listener.heard.get(0)).isInstanceOf(EmergencyStop.class);
  }
}
