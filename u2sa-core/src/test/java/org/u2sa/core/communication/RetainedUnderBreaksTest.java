package org.u2sa.core.communication;

import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.util.List;
import java.util.Random;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;

/** What is retained while the embedded broker comes and goes. */
@Timeout(180)
class RetainedUnderBreaksTest {
  private static final int BREAKS = 12;

  private static GoalList goals(int number) {
    Waypoint goal = new Waypoint();
    goal.uid("goal " + number).horizontalThreshold(1.0).verticalThreshold(1.0);
    return frozen(new GoalList().goals(List.of(goal)));
  }

  @Test
  void publishAllTheTime_brokerBreaksAgainAndAgain_theLastOneIsHeldEachTime() throws Exception {
    Random random = new Random(7);
    try (TestManager broker = new TestManager()) {
      Connection publisher = broker.remote("MissionManager", new RecordingReceiver());
      for (int round = 0; round < BREAKS; round++) {
        Thread breaker = new Thread(broker.manager()::restartBroker);
        breaker.start();
        int number = 0;
        while (breaker.isAlive() || number < 200) {
          publisher.publish(Channels.GOALS, goals(number++));
          LockSupport.parkNanos(random.nextInt(200_000)); // spreads them over the break
        }
        breaker.join();
        GoalList last = goals(1_000_000 + round);
        publisher.publish(Channels.GOALS, last); // perhaps while the link is renewed
        RecordingReceiver late = new RecordingReceiver();
        Connection subscriber = broker.remote("Late" + round, late);
        subscriber.subscribe(Channels.GOALS);
        soon().until(() -> late.messages.contains(last));
      }
    }
  }
}
