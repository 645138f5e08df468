package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.planning.PathPlanner;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.vehicle.ContactWatch;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.world.WorldModeler;
import org.u2sa.world.xml.WorldFile;

/**
 * The Mini-Molle on its way to a barrel, with a building between them. Both are known only from the
 * world file: no sensor sees them. Judged by truth.
 */
class KnownBuildingTest {
  private static final double STEP_S = 0.05;
  private static final double LIMIT_S = 90.0;
  private static final String WORLD =
      "<world><reference>Local ENU</reference>\n"
          + "<Box><uid>hall</uid><type>building</type><x>0</x><y>7.5</y><length>6</length><width>3</width>"
          + "<height>6</height></Box>\n"
          + "<Circle><uid>barrel 1</uid><type>barrel</type><x>0</x><y>15</y><radius>0.3</radius>"
          + "</Circle></world>";

  @TempDir private Path folder;
  private final ServiceKit kit = new ServiceKit();
  private final List<String> contacts = new ArrayList<>();

  @AfterEach
  void close() {
    kit.close();
  }

  @ParameterizedTest
  @ValueSource(strings = {"OBJECTS", "REACTIVE", "GRID"})
  void goal_namesAnotherType_buildingOfTheWorldFileIsDrivenAround(String modellers)
      throws IOException {
    Path file = Files.writeString(folder.resolve("world.xml"), WORLD);
    World world = World.at(new Geodetic(8.0, 50.0, 0.0)).with(WorldFile.load(file).objects());
    DifferentialVehicle vehicle =
        new DifferentialVehicle(DifferentialParameters.miniMolle(), new GroundStart(0.0, 0.0, 0.0));
    vehicle.enter(world);
    ContactWatch watch = new ContactWatch(contact -> contacts.add(contact.object().uid()));
    kit.with("MODELLERS", modellers).with("WORLD", file.toString()).start(WorldModeler::new);
    kit.withoutVariables();
    kit.with("PLANNER", "GRID").with("VEHICLE FRONT", 0.47).with("VEHICLE WIDTH", 0.52);
    kit.start(PathPlanner::new);
    kit.withoutVariables();
    kit.with("LEFT ACTUATOR", "LEFT MOTOR").with("RIGHT ACTUATOR", "RIGHT MOTOR");
    kit.start(DifferentialPursuitControl::new);
    GoalInformation goal = new ObjectGoal().uid("1").objectType("barrel").within(1.5);
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal)).upcoming(List.<GoalInformation>of()));
    kit.advance(0.5); // the World Modeler knows the goal before the planner looks

    while (kit.nowS() < LIMIT_S && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      kit.forget();
      kit.publish(Channels.STATE, state(vehicle.truth()));
      for (ActuatorCommand command : kit.published(Channels.ACTUATION)) {
        vehicle.command(command.actuatorName(), ((PercentageCommand) command).percentage() / 100.0);
      }
      vehicle.step(STEP_S);
      kit.advance(STEP_S);
      watch.look(vehicle, vehicle.truth());
    }

    assertThat(contacts).isEmpty();
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
  }

  private static StateInformation state(VehicleTruth truth) {
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(truth.position().y())
        .y(truth.position().x())
        .z(0.0)
        .psi(truth.headingRad())
        .xDot(truth.velocity().y())
        .yDot(truth.velocity().x())
        .psiDot(truth.rates().z());
  }
}
