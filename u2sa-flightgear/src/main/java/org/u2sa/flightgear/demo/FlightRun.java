package org.u2sa.flightgear.demo;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.core.mission.Mission;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.gcs.RunFailedException;
import org.u2sa.gcs.report.FlightOutcome;
import org.u2sa.gcs.report.FlightPlan;
import org.u2sa.gcs.report.RunFacts;
import org.u2sa.gcs.report.RunReport;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.LockstepClock;
import org.u2sa.interfaces.SystemClock;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.service.U2SAService;

/** One flight of a mission by the services of a system file, from start-up to report. */
final class FlightRun {
  /**
   * A crawl of 25 m/s over ground to every waypoint, and ten minutes to get ready: who takes longer
   * never arrives.
   */
  private static final double SLOWEST_MPS = 25.0;

  private static final double READY_WITHIN_S = 600.0;
  private static final long LOOK_EVERY_MICROS = 50_000;

  private final SystemFile system;
  private final Mission mission;
  private final Path directory;
  private final Terminal terminal;
  private final Interruption interruption;
  private final Clock stopwatch = new SystemClock();
  private List<PlannedSwap> swaps = List.of();

  /**
   * @param system the services that fly
   * @param directory where logs and report go
   * @param interruption ends the flight early
   */
  FlightRun(
      SystemFile system,
      Mission mission,
      Path directory,
      Terminal terminal,
      Interruption interruption) {
    this.system = system;
    this.mission = mission;
    this.directory = directory;
    this.terminal = terminal;
    this.interruption = interruption;
  }

  /** Sets which services are swapped on the way. */
  FlightRun swapping(List<PlannedSwap> planned) {
    swaps = List.copyOf(planned);
    return this;
  }

  /** Flies as fast as the machine allows, repeatable from the seed. */
  RunReport inLockstep(LaunchOptions options, long seed, Simulation simulation)
      throws InterruptedException {
    LockstepClock clock = new LockstepClock();
    return fly(
        options.clock(clock),
        clock,
        seed,
        simulation,
        observer ->
            clock.runUntil(() -> isOver(observer), clock.micros() + Clock.micros(limitS())));
  }

  /**
   * Flies in real time.
   *
   * @param simulation started once the services listen, ended after them
   * @param patience how long the aircraft may be silent [s]; empty: the default
   * @throws RunFailedException if nothing was heard of the aircraft
   */
  RunReport inRealTime(
      LaunchOptions options, long seed, Simulation simulation, OptionalDouble patience)
      throws InterruptedException {
    SystemClock clock = new SystemClock();
    return fly(
        options.clock(clock),
        clock,
        seed,
        simulation,
        observer -> {
          Clock.Waiter waiter = clock.newWaiter("flight");
          LinkWatch link = new LinkWatch(clock, patience, this::say);
          long limit = clock.micros() + Clock.micros(limitS());
          while (!isOver(observer)
              && clock.micros() < limit
              && !link.isHopeless(observer.readings())) {
            waiter.await(clock.micros() + LOOK_EVERY_MICROS);
          }
          if (observer.readings() == 0 && !interruption.isAsked()) {
            throw new RunFailedException(
                "no reading from the aircraft: " + simulation.name() + " did not appear");
          }
        });
  }

  private boolean isOver(FlightObserver observer) {
    return observer.isMissionOver()
        || observer.isCrashed()
        || observer.isLanded()
        || !observer.isRunning()
        || interruption.isAsked();
  }

  private void say(String line) {
    terminal.out().println(line);
    terminal.out().flush();
  }

  /** Waits until a flight is over. */
  @FunctionalInterface
  private interface Wait {
    void until(FlightObserver observer) throws InterruptedException;
  }

  private RunReport fly(
      LaunchOptions options, Clock clock, long seed, Simulation simulation, Wait wait)
      throws InterruptedException {
    FlightPlan plan = FlightPlans.of(mission);
    options.seed(seed).logDirectory(directory.resolve("logs"));
    long began = stopwatch.micros();
    try (FlightScreen screen = new FlightScreen(plan, terminal, stopwatch);
        Simulation simulated =
            simulation; // ended last, so that the neutral controls still reach it
        RunningSystem running = RunningSystem.start(system, options)) {
      FlightObserver observer =
          new FlightObserver(
              running.contextFor(XmlConfiguration.inMemory("FlightObserver", Map.of())),
              plan,
              screen);
      observer.start();
      Optional<SwapOperator> operator = startOperator(running);
      interruption.breakingOff(simulated::start);
      try {
        wait.until(observer);
      } finally {
        operator.ifPresent(SwapOperator::kill);
        observer.kill();
      }
      refuseFailed(running);
      refuseUnswapped(operator);
      double wallS = Clock.seconds(stopwatch.micros() - began);
      return RunReport.of(
          new RunFacts(
              "cessna", seed, simulated.name(), wallS, OptionalInt.of(observer.completed())),
          plan.within(fence(running)),
          observer.track(),
          new FlightOutcome(observer.isCrashed(), observer.isStalled(), List.of()));
    }
  }

  private static List<FlightPlan.Corner> fence(RunningSystem running) {
    return running.services().stream()
        .filter(SafetyManager.class::isInstance)
        .flatMap(manager -> ((SafetyManager) manager).fenceCorners().stream())
        .map(place -> new FlightPlan.Corner(place.longitudeDeg(), place.latitudeDeg()))
        .toList();
  }

  private Optional<SwapOperator> startOperator(RunningSystem running) {
    if (swaps.isEmpty()) {
      return Optional.empty();
    }
    SwapOperator operator =
        new SwapOperator(
            running.contextFor(XmlConfiguration.inMemory("SwapOperator", Map.of())),
            swaps,
            this::say);
    operator.start();
    return Optional.of(operator);
  }

  private static void refuseUnswapped(Optional<SwapOperator> operator) {
    operator
        .flatMap(SwapOperator::refusal)
        .ifPresent(
            refusal -> {
              throw new RunFailedException(refusal);
            });
  }

  private void refuseFailed(RunningSystem running) {
    for (U2SAService service : running.failed()) {
      throw new RunFailedException(
          "service "
              + service.getServiceName()
              + " failed in flight; its log is "
              + directory.resolve("logs").resolve(service.getServiceName() + ".log"));
    }
  }

  private double limitS() {
    return READY_WITHIN_S + FlightPlans.lengthM(FlightPlans.of(mission)) / SLOWEST_MPS;
  }
}
