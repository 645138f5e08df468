package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** One handler a channel, beside the thesis's callback. */
@Timeout(120)
class HandlerTest {
  private static final Channel<GoalInformation> OWN = Channel.every("own", GoalInformation.TYPE);
  private static final Channel<GoalCommand> NAMESAKE = Channel.every("own", GoalCommand.TYPE);

  @AutoClose private final ServiceKit kit = new ServiceKit();

  private static final class Listener extends EventDrivenService {
    private final List<String> reports = new ArrayList<>();
    private final List<String> updates = new ArrayList<>();
    private final List<U2SAData> others = new ArrayList<>();

    Listener(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Listener");
      subscribe(Channels.GOAL_REPORTS, report -> reports.add(report.uid()));
      subscribe(Channels.GOAL_UPDATES, update -> updates.add(update.uid()));
      subscribe(OWN, goal -> updates.add(goal.uid()));
      registerSubscriber(Channels.GOAL_COMMANDS);
    }

    @Override
    public void callback(U2SAData data) {
      others.add(data);
    }
  }

  /** Has handlers and no callback. */
  private static final class Handling extends EventDrivenService {
    private final List<String> heard = new ArrayList<>();

    Handling(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Handling");
      subscribe(Channels.GOAL_REPORTS, this::onReport);
      registerSubscriber(Channels.GOAL_COMMANDS);
    }

    private void onReport(GoalInformation report) {
      if (report.uid().isEmpty()) {
        throw new IllegalArgumentException("a goal without a name");
      }
      heard.add(report.uid());
    }

    private void listenOtherwise() {
      subscribe(Channels.GOAL_REPORTS, report -> heard.add("other " + report.uid()));
    }

    private void listenNoMore() {
      unregisterSubscriber(GoalInformation.class);
    }
  }

  private static Waypoint goal(String uid) {
    return new Waypoint().uid(uid).horizontalThreshold(1.0);
  }

  @Test
  void subscribe_twoChannelsOfOneType_eachHandlerGetsItsOwnAndCallbackTheRest() {
    Listener listener = kit.start(Listener::new);
    kit.publish(Channels.GOAL_REPORTS, goal("reported"));
    kit.publish(Channels.GOAL_UPDATES, goal("updated"));
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("commanded"));

    assertThat(listener.reports).containsExactly("reported");
    assertThat(listener.updates).containsExactly("updated");
    assertThat(listener.others).hasSize(1).first().isInstanceOf(GoalCommand.class);
  }

  @Test
  void subscribe_messageThatTheChannelDoesNotCarry_reachesNobody() {
    Listener listener = kit.start(Listener::new);
    kit.publish(NAMESAKE, new GoalCommand().uid("1"));

    assertThat(listener.updates).isEmpty();
    assertThat(listener.others).isEmpty();
  }

  @Test
  void callback_notWritten_logsWhatHasNoHandler() {
    kit.with("LOG LEVEL", "DEBUG");
    kit.start(Handling::new);
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("1"));

    assertThat(kit.log("Handling")).anyMatch(line -> line.contains("unexpected message: "));
  }

  @Test
  void handler_throws_isCountedAndTheNextMessageIsHandled() {
    Handling service = kit.start(Handling::new);
    kit.publish(Channels.GOAL_REPORTS, goal(""));
    kit.publish(Channels.GOAL_REPORTS, goal("1"));

    assertThat(service.heard).containsExactly("1");
    assertThat(service.isRunning()).isTrue();
    assertThat(kit.log("Handling")).anyMatch(line -> line.contains("a goal without a name"));
  }

  @Test
  void subscribe_again_theNewHandlerGetsEachMessageOnce() {
    Handling service = kit.start(Handling::new);
    service.listenOtherwise();
    kit.publish(Channels.GOAL_REPORTS, goal("1"));

    assertThat(service.heard).containsExactly("other 1");
  }

  @Test
  void unregister_thenPublish_handlerGetsNothing() {
    Handling service = kit.start(Handling::new);
    service.listenNoMore();
    kit.publish(Channels.GOAL_REPORTS, goal("1"));

    assertThat(service.heard).isEmpty();
  }
}
