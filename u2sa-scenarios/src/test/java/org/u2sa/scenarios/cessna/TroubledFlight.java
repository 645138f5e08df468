package org.u2sa.scenarios.cessna;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.estimation.PassThroughStateEstimator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.scenarios.cessna.FlightWitness.Moment;
import org.u2sa.sim.file.VehicleDevices;
import org.u2sa.testkit.Repository;

/**
 * A flight of the configured Cessna in lockstep, in which a scenario makes things go wrong: it
 * flies for a while, changes something, flies on.
 */
final class TroubledFlight implements AutoCloseable {
  /** Runway of the mission's home. */
  static final Geodetic HOME = new Geodetic(-157.943183, 21.325247, 17.5 * 0.3048);

  private static final double AIRBORNE_WITHIN_S = 200.0;

  private final LockstepClock clock = new LockstepClock();
  private final RunningSystem running;
  private final FlightWitness witness;

  private TroubledFlight(Path logs, long seed, String wind, UnaryOperator<LaunchOptions> changed) {
    Path root = Repository.root();
    String mission = root.resolve("missions/cessna/mission.xml").toAbsolutePath().toString();
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(seed)
            .logDirectory(logs)
            .override("CommunicationManager", "BROKER", "none")
            .override("MissionManager", "MISSION", mission)
            .override("Simulator", "MISSION", mission)
            .override("Simulator", "LINK", "embedded");
    options.devices(devices(Path.of(mission), DemoWind.parse(wind), seed));
    SystemFile system = SystemFile.read(root.resolve("config/cessna/system.xml"));
    running = RunningSystem.start(system, changed.apply(options));
    witness =
        new FlightWitness(
            running.contextFor(XmlConfiguration.inMemory("FlightWitness", Map.of())), HOME);
    witness.start();
  }

  /** Devices of the Cessna at the home of a mission. */
  static VehicleDevices devices(Path mission, DemoWind wind, long seed) {
    System.setProperty("u2sa.home", Repository.root().toString());
    RunPlan.Start start = CessnaDemo.onRunway(Mission.load(mission));
    return CessnaDemo.placed(start, wind.wind(seed), seed).devices();
  }

  /** On the runway, in the wind of the seed. */
  static TroubledFlight start(
      Path logs, long seed, String wind, UnaryOperator<LaunchOptions> changed) {
    return new TroubledFlight(logs, seed, wind, changed);
  }

  /** Takes off and flies until it is on its way to the second waypoint. */
  void flyIntoCruise() throws InterruptedException {
    flyUntil(() -> witness.reached().contains("1"), AIRBORNE_WITHIN_S);
  }

  void fly(double seconds) throws InterruptedException {
    clock.advance(Clock.micros(seconds));
  }

  /** Fails if it does not come to that. */
  void flyUntil(BooleanSupplier condition, double atMostS) throws InterruptedException {
    if (!clock.runUntil(condition, clock.micros() + Clock.micros(atMostS))) {
      throw new AssertionError(
          "not within " + atMostS + " s: " + witness.told() + ", " + witness.last());
    }
  }

  /** Puts another class in the place of the estimator. */
  void swapEstimator(Class<?> type) {
    order("StateEstimator", ServiceAction.SWAP, type.getName());
  }

  /** Puts the configured estimator back in its place. */
  void repairEstimator() {
    swapEstimator(PassThroughStateEstimator.class);
  }

  void order(String service, ServiceAction action, String className) {
    witness.say(
        Channels.SERVICE_ORDERS,
        new ServiceOrder()
            .requestId(service + clock.micros())
            .serviceName(service)
            .action(action)
            .className(className)
            .operator("scenario"));
  }

  FlightWitness witness() {
    return witness;
  }

  double nowS() {
    return Clock.seconds(clock.micros());
  }

  /** All that was seen since a time. */
  List<Moment> since(double timeS) {
    return witness.moments().stream().filter(moment -> moment.timeS() >= timeS).toList();
  }

  @Override
  public void close() {
    witness.kill();
    running.close();
  }
}
