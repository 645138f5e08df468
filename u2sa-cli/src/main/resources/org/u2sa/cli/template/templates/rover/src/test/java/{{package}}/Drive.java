package {{package}};

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.U2SAData;

/**
 * Runs a system in simulated time, as fast as the machine allows, and records the completed goals.
 */
final class Drive implements Receiver {
  private final List<String> completed = new ArrayList<>();

  private Drive() {}

  /**
   * The goals that a system completes, in order.
   *
   * @param goals number of goals to wait for
   * @param longestS simulated time after which to give up [s]
   */
  static List<String> completed(String systemFile, Path logs, int goals, double longestS)
      throws InterruptedException {
    Drive drive = new Drive();
    LockstepClock clock = new LockstepClock();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .logDirectory(logs)
            .override("CommunicationManager", "BROKER", "none");
    try (RunningSystem system = RunningSystem.start(SystemFile.read(Path.of(systemFile)), options);
        Connection judge = system.communicationManager().transport().connect("Judge", drive)) {
      judge.subscribe(Channels.GOAL_REPORTS);
      clock.runUntil(() -> drive.completed.size() == goals, Clock.micros(longestS));
    }
    return drive.completed;
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof GoalInformation goal && goal.completed()) {
      completed.add(goal.uid());
    }
  }

  @Override
  public void trouble(String what) {
    throw new AssertionError(what);
  }
}
