package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.testkit.ServiceKit;

/** What is answered when a role has no standard channel for a class (thesis 3.2.1.3, 3.2.1.4). */
class RegistrationByClassTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  private static final class Planner extends EventDrivenService {
    private final List<Boolean> answers = new ArrayList<>();

    Planner(ServiceContext context) {
      super(context, ServiceRole.PATH_PLANNER, "Planner");
      answers.add(registerSubscriber(NavigationPoint.class));
      answers.add(unregisterSubscriber(NavigationPoint.class));
      answers.add(registerPublisher(DiscoveryResponse.class));
      answers.add(unregisterPublisher(DiscoveryResponse.class));
      answers.add(registerSubscriber("Not A Channel"));
      answers.add(registerPublisher("Not A Channel"));
      answers.add(publish("Not A Channel", new StateInformation()));
      answers.add(publish(new DiscoveryResponse()));
    }
  }

  @Test
  void register_noStandardChannel_answersFalseAndLogsWhy() {
    Planner planner = kit.start(Planner::new);

    assertThat(planner.answers).hasSize(8).containsOnly(false);
    assertThat(kit.log("Planner"))
        .anyMatch(line -> line.contains("receives NavigationPoint: register with a channel"))
        .anyMatch(line -> line.contains("publishes DiscoveryResponse: register with a channel"))
        .anyMatch(line -> line.contains("channel \"Not A Channel\": expected lower-case words"))
        .anyMatch(line -> line.contains("not registered as a publisher of DiscoveryResponse"));
  }

  @Test
  void register_refused_leavesTheServiceAsItWas() {
    Planner planner = kit.start(Planner::new);

    assertThat(planner.isRunning()).isTrue();
    assertThat(planner.registerSubscriber(StateInformation.class)).isTrue();
    assertThat(planner.subscribedChannels()).containsExactly(Channels.STATE);
  }
}
