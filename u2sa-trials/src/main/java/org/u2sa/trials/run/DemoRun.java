package org.u2sa.trials.run;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.cli.run.MavlinkLinks;
import org.u2sa.cli.run.SafetyLines;
import org.u2sa.cli.run.TroubleLines;
import org.u2sa.cli.terminal.Console;
import org.u2sa.cli.terminal.PlainLines;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.gcs.remote.LocalSystems;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.summary.RunReport;
import org.u2sa.service.U2SAService;
import org.u2sa.trials.terminal.LiveStatus;

/**
 * One run of a mission with the services of a system file, from start-up to report.
 *
 * @param demo name in reports
 * @param system the system file's services
 * @param plan the planned route
 * @param goals names of the mission's goals
 * @param limitS time limit [s]
 * @param maker creates the ground-truth observer
 * @param directory output directory of logs and report
 * @param interruption ends the run early
 * @param swaps hot swaps of services during the run
 * @param mavlink links to MAVLink ground stations
 */
record DemoRun(
    String demo,
    SystemFile system,
    RunPlan plan,
    Set<String> goals,
    double limitS,
    RunObserver.Maker maker,
    Path directory,
    Terminal terminal,
    Interruption interruption,
    List<SwapOperator.PlannedSwap> swaps,
    MavlinkLinks mavlink) {
  private static final long LOOK_EVERY_MICROS = 50_000;
  private static final double ARMED_WITHIN_S = 10.0; // longer than estimators need for a start
  private static final Clock STOPWATCH = new SystemClock();

  /** Runs in lockstep, as fast as the machine allows; reproducible from the seed. */
  public RunReport inLockstep(LaunchOptions options, long seed, Simulation simulation)
      throws InterruptedException {
    LockstepClock clock = new LockstepClock();
    return run(
        options.clock(clock),
        clock,
        seed,
        simulation,
        (observer, screen) ->
            clock.runUntil(() -> isOver(observer), clock.micros() + Clock.micros(limitS())));
  }

  /**
   * Runs in real time.
   *
   * @param simulation started once the services have subscribed, stopped after them
   * @param patience timeout without readings of the vehicle [s]; empty for the default
   * @throws RunFailedException if no reading arrived from the vehicle
   */
  public RunReport inRealTime(
      LaunchOptions options, long seed, Simulation simulation, OptionalDouble patience)
      throws InterruptedException {
    SystemClock clock = new SystemClock();
    return run(
        options.clock(clock),
        clock,
        seed,
        simulation,
        (observer, screen) -> {
          Clock.Waiter waiter = clock.newWaiter("run");
          ReadingsWatch link =
              new ReadingsWatch(clock, simulation.vehicle(), patience, screen::print);
          long limit = clock.micros() + Clock.micros(limitS());
          while (!isOver(observer)
              && clock.micros() < limit
              && !link.isHopeless(observer.record().readings())) {
            waiter.await(clock.micros() + LOOK_EVERY_MICROS);
          }
          if (observer.record().readings() == 0 && !interruption.isAsked()) {
            throw new RunFailedException(
                "no reading from the "
                    + simulation.vehicle()
                    + ": "
                    + simulation.name()
                    + " did not appear");
          }
        });
  }

  private boolean isOver(RunObserver observer) {
    return observer.isOver() || !observer.service().isRunning() || interruption.isAsked();
  }

  /** Waits until a run is over. */
  @FunctionalInterface
  private interface Wait {
    void until(RunObserver observer, RunScreen screen) throws InterruptedException;
  }

  @SuppressWarnings("try") // resources used only for closing
  private RunReport run(
      LaunchOptions options, Clock clock, long seed, Simulation simulation, Wait wait)
      throws InterruptedException {
    options.seed(seed).logDirectory(directory.resolve("logs"));
    SwapOperator.PlannedSwap.requireClasses(swaps, options);
    long began = STOPWATCH.micros();
    try (Console.Detached output = PlainLines.detach(terminal.out(), clock);
        RunScreen screen = new RunScreen(plan, terminal, STOPWATCH);
        Simulation simulated = simulation; // closed last, so that neutral commands still reach it
        RunningSystem running = RunningSystem.start(system, options.console(screen::print));
        TroubleLines troubles = plannersTroubles(running, screen);
        SafetyLines safety = safety(running, clock, screen);
        LocalSystems.Announcement announced = announced(running, screen);
        MavlinkLinks.Bridges bridges = mavlink.start(system, running, screen::print)) {
      RunObserver observer =
          maker.make(
              running.contextFor(XmlConfiguration.inMemory("RunObserver", Map.of())), plan, screen);
      if (safetyManager(running).isPresent()) {
        observer.record().within(() -> safetyManager(running).flatMap(SafetyManager::fence));
      }
      observer.service().start();
      Optional<SwapOperator> operator = startOperator(running, screen);
      interruption.breakingOff(simulated::start);
      try {
        wait.until(observer, screen);
      } finally {
        operator.ifPresent(SwapOperator::kill);
        observer.service().kill();
      }
      refuseFailed(running);
      operator.ifPresent(SwapOperator::tellMissed);
      Set<String> pursued = observer.record().goals(goals);
      int completed = observer.record().completed(goals).size();
      if (completed < pursued.size()) {
        troubles.printRest();
        terminal.out().println("Logs: " + directory.resolve("logs"));
      }
      double wallS = Clock.seconds(STOPWATCH.micros() - began);
      return RunReport.of(
          new RunDetails(
              demo,
              seed,
              simulated.name(),
              wallS,
              OptionalInt.of(pursued.size()),
              OptionalInt.of(completed),
              safety.interventions()),
          observer.record().plan(),
          observer.record().track(),
          observer.record().counted(outcome(observer)).breaking(refusals(operator)));
    }
  }

  private static List<String> refusals(Optional<SwapOperator> operator) {
    return operator.map(SwapOperator::refusals).orElse(List.of());
  }

  /** The observer's outcome, plus the numbers of waypoints moved and omitted for others. */
  private RunOutcome outcome(RunObserver observer) {
    Set<String> leftOut = observer.record().leftOut();
    int waypoints =
        (int) plan.waypoints().stream().filter(at -> leftOut.contains(at.name())).count();
    RunOutcome outcome =
        observer
            .outcome()
            .breaking(
                observer.record().unrepeated(goals).stream()
                    .map(goal -> "goal \"" + goal + "\" was not repeated as often as planned")
                    .toList());
    int moved = observer.record().moved().size();
    if (moved > 0) {
      outcome = outcome.counting(RunOutcome.WAYPOINTS_MOVED, moved);
    }
    return waypoints == 0 ? outcome : outcome.counting(RunOutcome.WAYPOINTS_LEFT_OUT, waypoints);
  }

  /**
   * Reports limitations of the planner and of the map immediately, such as unattainable thresholds
   * and obstacles that could not be read.
   */
  private static TroubleLines plannersTroubles(RunningSystem running, RunScreen screen) {
    return new TroubleLines(
        running.communicationManager().transport(),
        Set.of("PathPlanner", "WorldModeler")::contains,
        STOPWATCH,
        screen::print);
  }

  private static SafetyLines safety(RunningSystem running, Clock clock, RunScreen screen) {
    return new SafetyLines(
        running.communicationManager().transport(), clock, ARMED_WITHIN_S, screen::print);
  }

  private LocalSystems.Announcement announced(RunningSystem running, RunScreen screen) {
    return LocalSystems.ofAccount()
        .announce(system.systemId(), running.communicationManager().address(), screen::print);
  }

  /** The running Safety Manager, also a restarted or swapped one. */
  private static Optional<SafetyManager> safetyManager(RunningSystem running) {
    return running.services().stream()
        .filter(SafetyManager.class::isInstance)
        .map(SafetyManager.class::cast)
        .findFirst();
  }

  private Optional<SwapOperator> startOperator(RunningSystem running, RunScreen screen) {
    if (swaps.isEmpty()) {
      return Optional.empty();
    }
    SwapOperator.PlannedSwap.requireServices(
        swaps, running.services().stream().map(U2SAService::getServiceName).toList());
    SwapOperator operator =
        new SwapOperator(
            running.contextFor(XmlConfiguration.inMemory("SwapOperator", Map.of())),
            swaps,
            screen::print);
    operator.start();
    return Optional.of(operator);
  }

  private void refuseFailed(RunningSystem running) {
    for (U2SAService service : running.failed()) {
      throw new RunFailedException(
          "service "
              + service.getServiceName()
              + " failed in the run; its log is "
              + directory.resolve("logs").resolve(service.getServiceName() + ".log"));
    }
  }

  /** Shows the progress of a run on the terminal. {@link #accept} is confined to one thread. */
  private static final class RunScreen implements Consumer<TrackSample>, AutoCloseable {
    private final RunPlan plan;
    private final LiveStatus live;
    private final Clock stopwatch;
    private final long startMicros;

    /**
     * @param stopwatch real time, even in faster runs
     */
    RunScreen(RunPlan plan, Terminal terminal, Clock stopwatch) {
      this.plan = plan;
      live = new LiveStatus(terminal);
      this.stopwatch = stopwatch;
      startMicros = stopwatch.micros();
    }

    @Override
    public void accept(TrackSample sample) {
      int count = plan.waypoints().size();
      boolean underWay = sample.leg() >= 0 && sample.leg() < count;
      live.update(
          new LiveStatus.Moment(
              sample,
              sample.leg() + 1,
              count,
              underWay ? plan.waypoints().get(sample.leg()).name() : "",
              () -> plan.distanceM(sample.leg(), sample.longitudeDeg(), sample.latitudeDeg()),
              Clock.seconds(stopwatch.micros() - startMicros)));
    }

    /** Prints a line about an event. Thread-safe. */
    void print(String line) {
      live.print(line);
    }

    @Override
    public void close() {
      live.close();
    }
  }
}
