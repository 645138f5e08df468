package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.control.fixedwing.CessnaControl;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.planning.PathPlanner;
import org.u2sa.planning.VectorFieldPlanner;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.testkit.Repository;
import org.u2sa.trials.run.SwapOperator;

/** What the other services see of swaps all along the demo's flight: nothing. */
class HotSwapGapTest {
  private static final double LIMIT_S = 2_000.0;

  @TempDir private Path directory;

  /** Measures times between messages, and notes which goals are reported. */
  private static final class Observer extends EventDrivenService {
    private final Map<String, Long> lastMicros = new HashMap<>();
    private final Map<String, Long> longestMicros = new HashMap<>();
    private final Map<String, Double> lastPercent = new HashMap<>();
    private final Map<String, Double> largestJump = new HashMap<>(); // [%] between two commands
    private final List<String> reached = new ArrayList<>();

    Observer(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Observer");
      registerSubscriber(Channels.NAVIGATION);
      registerSubscriber(Channels.ACTUATION);
      registerSubscriber(Channels.GOAL_REPORTS);
    }

    @Override
    public void callback(U2SAData data) {
      if (data instanceof NavigationPoint) {
        heard("NAVIGATION");
      } else if (data instanceof PercentageCommand command) {
        heard(command.actuatorName());
        Double before = lastPercent.put(command.actuatorName(), command.percentage());
        if (before != null) {
          largestJump.merge(
              command.actuatorName(), Math.abs(command.percentage() - before), Math::max);
        }
      } else if (data instanceof GoalInformation report && report.completed()) {
        reached.add(report.uid());
      }
    }

    private void heard(String what) {
      Long before = lastMicros.put(what, clock().micros());
      if (before != null) {
        longestMicros.merge(what, clock().micros() - before, Math::max);
      }
    }
  }

  private Observer fly(String name, int waypoints, List<SwapOperator.PlannedSwap> swaps)
      throws InterruptedException {
    Path root = Repository.root();
    String mission = root.resolve("missions/cessna/mission.xml").toAbsolutePath().toString();
    LockstepClock clock = new LockstepClock();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(2)
            .logDirectory(directory.resolve(name))
            .override("CommunicationManager", "BROKER", "none")
            .override("MissionManager", "MISSION", mission)
            .override("Simulator", "MISSION", mission)
            .override("Simulator", "LINK", "embedded");
    options.devices(TroubledFlight.devices(Path.of(mission), DemoWind.parse("8@200"), 2));
    SystemFile system = SystemFile.read(root.resolve("config/cessna/system.xml"));
    try (RunningSystem running = RunningSystem.start(system, options)) {
      Observer observer =
          new Observer(running.contextFor(XmlConfiguration.inMemory("Observer", Map.of())));
      SwapOperator operator =
          new SwapOperator(
              running.contextFor(XmlConfiguration.inMemory("SwapOperator", Map.of())),
              swaps,
              line -> {});
      observer.start();
      operator.start();
      assertThat(clock.runUntil(() -> observer.reached.size() >= waypoints, Clock.micros(LIMIT_S)))
          .isTrue();
      assertThat(operator.refusals()).isEmpty();
      operator.kill();
      observer.kill();
      return observer;
    }
  }

  @Test
  void swap_everyFiveSeconds_noGapNoJumpNoWaypointTwice() throws InterruptedException {
    requireUnnoticed(4);
  }

  @Tag("long")
  @Test
  void swap_everyFiveSecondsOfTheWholeMission_noGapNoJumpNoWaypointTwice()
      throws InterruptedException {
    requireUnnoticed(10);
  }

  private void requireUnnoticed(int waypoints) throws InterruptedException {
    List<SwapOperator.PlannedSwap> swaps = new ArrayList<>();
    for (double atS = 2.5; atS < 1_190.0; atS += 10.0) {
      swaps.add(
          new SwapOperator.PlannedSwap(atS, "PathPlanner", VectorFieldPlanner.class.getName()));
      swaps.add(new SwapOperator.PlannedSwap(atS + 2.5, "Control", CessnaControl.class.getName()));
      swaps.add(
          new SwapOperator.PlannedSwap(atS + 5.0, "PathPlanner", PathPlanner.class.getName()));
    }

    Observer without = fly("without", waypoints, List.of());
    Observer with = fly("with", waypoints, swaps);

    assertThat(with.reached)
        .isEqualTo(IntStream.rangeClosed(1, waypoints).mapToObj(String::valueOf).toList());
    assertThat(with.longestMicros).containsExactlyInAnyOrderEntriesOf(without.longestMicros);
    with.largestJump.forEach(
        (actuator, percent) ->
            assertThat(percent)
                .as(actuator)
                .isLessThanOrEqualTo(without.largestJump.get(actuator) + 5.0));
  }
}
