package org.u2sa.scenarios.fields;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.planning.PathPlanner;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.vehicle.ContactWatch;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;

/** The Mini-Molle with planner and control in lockstep, in a field that it sees as far as 8 m. */
final class RoverRun implements AutoCloseable {
  static final RandomField.Kind KIND =
      new RandomField.Kind(28.0, 0.25, 1.6, 0.25, 1.2, 3, 0.3, 0.5, 3, true);

  /** The circle that the vehicle fills as it turns, CLEARANCE, and a cell of the map [m]. */
  static final double NEEDED_M = 0.54 + 0.1 + 0.1;

  private static final double STEP_S = 0.05;
  private static final double LIMIT_S = 420.0;
  private static final double STANDS_MPS = 0.05; // towards what touches it: less is no driving into
  private static final Map<String, Object> PLANNER =
      Map.ofEntries(
          Map.entry("PLANNER", "GRID"),
          Map.entry("LOOK AHEAD", 1.0),
          Map.entry("LOOK AHEAD TIME", 0.8),
          Map.entry("VEHICLE FRONT", 0.47),
          Map.entry("VEHICLE REAR", 0.1),
          Map.entry("VEHICLE WIDTH", 0.52),
          Map.entry("CLEARANCE", 0.1),
          Map.entry("INFLATION", 0.8),
          Map.entry("PLANNING SPAN", 60.0),
          Map.entry("REVERSES", true),
          Map.entry("PLANNED BRAKING", 1.0));

  final ServiceKit kit = new ServiceKit();
  private final RandomField field;
  private final DifferentialVehicle vehicle;
  private final RoverEyes eyes;
  private final Set<Integer> touched = new HashSet<>();
  private final List<String> contacts = new ArrayList<>(); // what it drove into
  private final List<String> touchedBy = new ArrayList<>(); // traffic, while it stood or backed off
  private final ContactWatch watch =
      new ContactWatch(
          c -> contacts.add(c.object().uid() + " at " + Math.round(10.0 * c.timeS()) / 10.0));

  /**
   * @param sees what tells of the surroundings
   */
  RoverRun(RandomField field, RoverEyes.Kind sees) {
    this.field = field;
    World world = World.at(new Geodetic(8.0, 50.0, 0.0)).with(field.obstacles);
    vehicle =
        new DifferentialVehicle(
            DifferentialParameters.miniMolle(),
            new GroundStart(field.startEast, field.startNorth, field.startHeading));
    vehicle.enter(world);
    PLANNER.forEach(kit::with);
    kit.start(PathPlanner::new);
    kit.withoutVariables();
    kit.with("LEFT ACTUATOR", "LEFT MOTOR").with("RIGHT ACTUATOR", "RIGHT MOTOR");
    kit.start(DifferentialPursuitControl::new);
    eyes =
        sees == RoverEyes.Kind.KNOWN
            ? new KnownEyes(field, world, kit)
            : new ModelledEyes(field, world, kit, sees == RoverEyes.Kind.DETECTOR);
  }

  FieldResult run() {
    List<double[]> track = new ArrayList<>();
    boolean reported = false;
    String reason = "";
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal())).upcoming(List.<Waypoint>of()));
    while (kit.nowS() < LIMIT_S && !reported) {
      VehicleTruth truth = vehicle.truth();
      double east = truth.position().x();
      double north = truth.position().y();
      eyes.look(truth);
      track.add(new double[] {east, north});
      kit.publish(Channels.STATE, state(truth));
      for (ActuatorCommand command : kit.published(Channels.ACTUATION)) {
        vehicle.command(command.actuatorName(), ((PercentageCommand) command).percentage() / 100.0);
      }
      Optional<GoalInformation> report = kit.latest(Channels.GOAL_REPORTS);
      if (report.isPresent()) {
        reported = true;
        reason = report.get().completed() ? "" : report.get().reason().orElse("no reason");
      }
      kit.forget();
      vehicle.step(STEP_S);
      kit.advance(STEP_S);
      watch.look(vehicle, vehicle.truth());
      touchTraffic();
    }
    VehicleTruth truth = vehicle.truth();
    boolean there =
        Math.hypot(truth.position().x() - field.goalEast, truth.position().y() - field.goalNorth)
            < 0.7;
    return new FieldResult(
        reported && reason.isEmpty() && there, reason, contacts, touchedBy, kit.nowS(), track);
  }

  private Waypoint goal() {
    return new Waypoint()
        .uid("1")
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(field.goalEast)
        .y(field.goalNorth)
        .horizontalThreshold(0.5);
  }

  private static StateInformation state(VehicleTruth truth) {
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(truth.position().y())
        .y(truth.position().x())
        .psi(truth.headingRad())
        .xDot(truth.velocity().y())
        .yDot(truth.velocity().x())
        .psiDot(truth.rates().z());
  }

  /** Contact with what moves: the vehicle's rectangle against its disc. */
  private void touchTraffic() {
    VehicleTruth truth = vehicle.truth();
    double sin = Math.sin(truth.headingRad());
    double cos = Math.cos(truth.headingRad());
    for (int i = 0; i < field.traffic.size(); i++) {
      RandomField.Traffic other = field.traffic.get(i);
      double de = other.eastM(kit.nowS()) - truth.position().x();
      double dn = other.northM(kit.nowS()) - truth.position().y();
      double ahead = de * sin + dn * cos;
      double right = de * cos - dn * sin;
      double beyond =
          Math.hypot(
              Math.max(0.0, Math.max(ahead - 0.46, -0.1 - ahead)),
              Math.max(0.0, Math.abs(right) - 0.26));
      if (beyond < other.radiusM && touched.add(i)) {
        String what = "T" + i + " at " + Math.round(10.0 * kit.nowS()) / 10.0;
        double away = Math.hypot(de, dn);
        double towardsMps = (truth.velocity().x() * de + truth.velocity().y() * dn) / away;
        (towardsMps > STANDS_MPS ? contacts : touchedBy).add(what);
      }
    }
  }

  @Override
  public void close() {
    kit.close();
  }
}
