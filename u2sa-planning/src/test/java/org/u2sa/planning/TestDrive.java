package org.u2sa.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.mission.MissionManager;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

/** Mission Manager and Path Planner in lockstep with a test vehicle. */
final class TestDrive implements AutoCloseable {
  private static final double STEP_S = 0.05;

  /**
   * Where the vehicle was: north, east, altitude [m], and the goals that were completed by then.
   */
  record Sample(double north, double east, double altitude, int goalsDone) {}

  final ServiceKit kit = new ServiceKit();
  final List<Sample> track = new ArrayList<>();
  private final TestVehicle vehicle;
  private final Map<String, Object> managerVariables;
  private MissionManager manager;

  TestDrive(TestVehicle vehicle, String missionFile, Map<String, Object> planner) {
    this(vehicle, Map.of("MISSION", missionFile), planner);
  }

  TestDrive(TestVehicle vehicle, Map<String, Object> manager, Map<String, Object> planner) {
    this(vehicle, manager, planner, PathPlanner::new);
  }

  TestDrive(
      TestVehicle vehicle,
      Map<String, Object> manager,
      Map<String, Object> planner,
      Function<ServiceContext, U2SAService> make) {
    this.vehicle = vehicle;
    managerVariables = manager;
    configureManager();
    this.manager = kit.start(MissionManager::new);
    kit.withoutVariables();
    planner.forEach(kit::with);
    kit.start(make);
    kit.withoutVariables();
  }

  private void configureManager() {
    kit.withoutVariables().with("DEFAULT THRESHOLD", 100.0);
    managerVariables.forEach(kit::with);
  }

  /** Ends the Mission Manager and starts it again, as a launcher does. */
  void restartManager() {
    configureManager();
    manager = kit.restart(manager, MissionManager::new);
    kit.withoutVariables();
  }

  /** Drives until the condition holds, or for that long; answers whether it held. */
  boolean until(BooleanSupplier done, double limitS) {
    for (double end = kit.nowS() + limitS; kit.nowS() < end && !done.getAsBoolean(); ) {
      long before = kit.clock().micros();
      kit.publish(Channels.STATE, vehicle.state());
      Optional<NavigationPoint> point =
          kit.latest(Channels.NAVIGATION).filter(p -> p.timestamp().orElse(-1L) == before);
      vehicle.step(STEP_S, point);
      track.add(new Sample(vehicle.north, vehicle.east, vehicle.altitude, reports().size()));
      kit.advance(STEP_S);
    }
    return done.getAsBoolean();
  }

  boolean isMissionOver() {
    return kit.latest(Channels.GOALS).orElseThrow().goals().isEmpty();
  }

  List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }

  /** How near the vehicle came to a place [m]. */
  double missM(double north, double east) {
    return track.stream()
        .mapToDouble(s -> Math.hypot(s.north() - north, s.east() - east))
        .min()
        .orElseThrow();
  }

  @Override
  public void close() {
    kit.close();
  }
}
