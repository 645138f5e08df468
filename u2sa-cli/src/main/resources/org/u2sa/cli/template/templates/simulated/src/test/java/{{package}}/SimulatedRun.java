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
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.sim.file.VehicleDevices;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.world.World;

/**
 * Runs a system with its simulated vehicle, as fast as the machine allows, and notes the goals that
 * it completes.
 */
final class SimulatedRun implements Receiver {
  private static final long SEED = 1;

  private final List<String> completed = new ArrayList<>();

  private SimulatedRun() {}

  /**
   * The goals that a folder's system completes, in order.
   *
   * @param home starting position, facing north: the mission's home
   * @param goals number of goals to wait for
   * @param longestS simulated time after which to give up [s]
   */
  static List<String> completed(
      Path folder, Geodetic home, Path logs, int goals, double longestS)
      throws InterruptedException {
    VehicleFile file = VehicleFile.load(folder.resolve("vehicle.xml"));
    World world = file.home(World.at(home));
    VehicleRun vehicle = new VehicleRun(file.make(world, Point.ORIGIN, 0.0, SEED));
    SimulatedRun run = new SimulatedRun();
    LockstepClock clock = new LockstepClock();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(SEED)
            .logDirectory(logs)
            .devices(new VehicleDevices(file, vehicle, SEED))
            .override("CommunicationManager", "BROKER", "none");
    try (RunningSystem system =
            RunningSystem.start(SystemFile.read(folder.resolve("system.xml")), options);
        Connection judge = system.communicationManager().transport().connect("Judge", run)) {
      judge.subscribe(Channels.GOAL_REPORTS);
      clock.runUntil(() -> run.completed.size() == goals, Clock.micros(longestS));
    }
    return run.completed;
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
