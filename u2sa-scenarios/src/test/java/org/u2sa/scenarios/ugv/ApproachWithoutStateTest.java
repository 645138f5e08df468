package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.shape.Circle;
import org.u2sa.planning.PathPlanner;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.world.WorldModeler;

/**
 * The Mini-Molle without any State Estimator: a camera sees a barrel in the vehicle's own axes,
 * World Modeler, Path Planner and control do the rest (thesis 4.3.2). Judged by truth.
 */
class ApproachWithoutStateTest {
  private static final double STEP_S = 0.05;
  private static final double EXPIRY_S = 0.5; // of commands, if not renewed
  private static final double BARREL_EAST = 9.0;
  private static final double BARREL_NORTH = 4.0;
  private static final double BARREL_RADIUS = 0.3;
  private static final double WITHIN_M = 1.5;

  private final ServiceKit kit = new ServiceKit();
  private final DifferentialVehicle vehicle =
      new DifferentialVehicle(
          DifferentialParameters.miniMolle(), new GroundStart(1.0, 2.0, Math.toRadians(-60.0)));
  private double commandedAtS = Double.NEGATIVE_INFINITY;
  private boolean sees = true;

  private void start() {
    kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    kit.withoutVariables();
    kit.start(PathPlanner::new);
    kit.with("LEFT ACTUATOR", "LEFT MOTOR").with("RIGHT ACTUATOR", "RIGHT MOTOR");
    kit.start(DifferentialPursuitControl::new);
    GoalInformation goal =
        new ObjectGoal().uid("barrel").objectType("barrel").within(WITHIN_M).speed(0.5);
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal)).upcoming(List.<GoalInformation>of()));
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private void drive(double seconds) {
    for (double t = 0.0; t < seconds; t += STEP_S) {
      if (sees) {
        kit.publish(Channels.SENSED_OBJECTS, seen(vehicle.truth()));
      }
      for (ActuatorCommand command : kit.published(Channels.ACTUATION)) {
        commandedAtS = kit.nowS();
        vehicle.command(command.actuatorName(), ((PercentageCommand) command).percentage() / 100.0);
      }
      if (kit.nowS() - commandedAtS > EXPIRY_S) { // as a motor driver does
        vehicle.command("LEFT MOTOR", 0.0);
        vehicle.command("RIGHT MOTOR", 0.0);
      }
      if (kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
        kit.forget();
      }
      vehicle.step(STEP_S);
      kit.advance(STEP_S);
    }
  }

  /** The barrel, ahead and to the left. */
  private ObjectDescription seen(VehicleTruth truth) {
    double east = BARREL_EAST - truth.position().x();
    double north = BARREL_NORTH - truth.position().y();
    double sin = Math.sin(truth.headingRad());
    double cos = Math.cos(truth.headingRad());
    Circle barrel =
        new Circle()
            .radius(BARREL_RADIUS)
            .uid("B")
            .objectType("barrel")
            .referenceFrame(ReferenceFrame.BODY)
            .x(east * sin + north * cos)
            .y(north * sin - east * cos);
    barrel.sensorName("CAMERA").timestamp(kit.clock().micros());
    return barrel;
  }

  private double distanceM() {
    VehicleTruth truth = vehicle.truth();
    return Math.hypot(BARREL_EAST - truth.position().x(), BARREL_NORTH - truth.position().y())
        - BARREL_RADIUS;
  }

  private double speedMps() {
    return Math.hypot(vehicle.truth().velocity().x(), vehicle.truth().velocity().y());
  }

  @Test
  void objects_barrelSeenFromVehicleWithoutState_isApproachedAndVehicleStops() {
    start();
    drive(60.0);
    assertThat(kit.published(Channels.STATE)).isEmpty();
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(distanceM()).isBetween(WITHIN_M - 0.5, WITHIN_M); // it rolls until commands expire
    assertThat(speedMps()).isCloseTo(0.0, within(0.01));
  }

  @Test
  void objects_cameraFailsOnTheWay_vehicleStops() {
    start();
    drive(10.0);
    assertThat(speedMps()).isGreaterThan(0.3);
    sees = false;
    drive(6.0);
    assertThat(speedMps()).isCloseTo(0.0, within(0.01));
    assertThat(distanceM()).isGreaterThan(WITHIN_M);
  }
}
