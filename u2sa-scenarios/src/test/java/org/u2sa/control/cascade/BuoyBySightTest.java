package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.planning.PathPlanner;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.world.WorldModeler;

/**
 * The BlueROV2 without any State Estimator: a camera sees a buoy in the vehicle's own axes, World
 * Modeler, Path Planner and AllocatingControl take it there (thesis 4.3.2). Judged by truth.
 */
class BuoyBySightTest {
  private static final Point BUOY = Point.of(6.0, 4.0, 9.0); // north, east, down [m]
  private static final double RADIUS_M = 0.3;
  private static final double WITHIN_M = 1.5; // horizontal; half as much above or below
  private static final double NEAR_M = Math.hypot(WITHIN_M, 0.5 * WITHIN_M);

  private final SixThrusterDive dive = new SixThrusterDive(0.0, 0.05);
  private PathPlanner planner;
  private boolean sees = true;
  private boolean hasVelocityLog;

  @AfterEach
  void close() {
    dive.close();
  }

  /** Puts a control that turns to the buoy, or not, in the place of the dive's own. */
  private void start(boolean facesTheWay) {
    dive.control.kill();
    dive.kit.withoutVariables();
    dive.kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    dive.kit.withoutVariables();
    planner = dive.kit.start(PathPlanner::new);
    variables(facesTheWay);
    dive.control = dive.kit.start(AllocatingControl::new);
    GoalInformation goal = new ObjectGoal().uid("buoy").objectType("buoy").within(WITHIN_M);
    dive.kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal)).upcoming(List.of()));
  }

  private void variables(boolean facesTheWay) {
    dive.kit.withoutVariables();
    SixThrusterDive.tuning().forEach(dive.kit::with);
    dive.kit.with("FACES THE WAY", facesTheWay);
  }

  private void dive(double seconds) {
    for (double end = dive.kit.nowS() + seconds - 1e-9; dive.kit.nowS() < end; ) {
      VehicleTruth truth = dive.run.at(dive.kit.clock().micros());
      dive.track.add(truth);
      if (sees) {
        dive.kit.publish(Channels.SENSED_OBJECTS, seen(truth));
      }
      if (hasVelocityLog) {
        measure(truth);
      }
      dive.kit.advance(SixThrusterDive.STEP_S);
    }
  }

  /** As IMU and velocity log of a vehicle that lies level and hardly turns. */
  private void measure(VehicleTruth truth) {
    StateInformation imu = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    dive.kit.publish(Channels.SENSED_STATE, imu.psiDot(truth.rates().z()));
    Point ned = Point.of(truth.velocity().y(), truth.velocity().x(), -truth.velocity().z());
    Point frd = truth.attitude().bodyOf(ned);
    StateInformation log = new StateInformation().referenceFrame(ReferenceFrame.BODY);
    dive.kit.publish(Channels.SENSED_STATE, log.xDot(frd.x()).yDot(frd.y()).zDot(frd.z()));
  }

  private static Point place(VehicleTruth truth) {
    return Point.of(truth.position().y(), truth.position().x(), -truth.position().z());
  }

  private static ObjectDescription seen(VehicleTruth truth) {
    Point body = truth.attitude().bodyOf(BUOY.minus(place(truth)));
    return new Sphere()
        .radius(RADIUS_M)
        .uid("B")
        .objectType("buoy")
        .sensorName("CAMERA")
        .referenceFrame(ReferenceFrame.BODY)
        .x(body.x())
        .y(body.y())
        .z(body.z());
  }

  private VehicleTruth truth() {
    return dive.run.at(dive.kit.clock().micros());
  }

  private double distanceM() {
    return BUOY.distanceTo(place(truth())) - RADIUS_M;
  }

  private double nearestM() {
    return dive.track.stream()
        .mapToDouble(truth -> BUOY.distanceTo(place(truth)) - RADIUS_M)
        .min()
        .orElseThrow();
  }

  private double bearingOffDeg() {
    Point way = BUOY.minus(place(truth()));
    return Math.toDegrees(
        Math.IEEEremainder(Math.atan2(way.y(), way.x()) - truth().attitude().psi(), 2.0 * Math.PI));
  }

  private boolean isReached() {
    return dive.kit.published(Channels.GOAL_REPORTS).stream().anyMatch(GoalInformation::completed);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void objects_buoySeenWithoutState_isApproachedAndThrustersAreLetGo(boolean facesTheWay) {
    start(facesTheWay);
    double before = distanceM();
    dive(50.0);

    assertThat(before).isGreaterThan(6.0);
    assertThat(dive.kit.published(Channels.STATE)).isEmpty();
    assertThat(isReached()).isTrue();
    assertThat(nearestM()).isBetween(0.5, NEAR_M); // it glides on until the water stops it
    assertThat(dive.thrusters.keySet()).allSatisfy(name -> assertThat(isDriven(name)).isFalse());
  }

  /** Whether a thruster was commanded something in the last second. */
  private boolean isDriven(String thruster) {
    return dive.lastDrivenS(thruster) > dive.kit.nowS() - 1.0;
  }

  @Test
  void objects_buoyAside_vehicleTurnsToItAndHardlySwings() {
    start(true);
    assertThat(Math.abs(bearingOffDeg())).isGreaterThan(30.0);
    dive(4.0);
    keepsFacing(20);
  }

  private void keepsFacing(int halfSeconds) {
    for (int i = 0; i < halfSeconds; i++) {
      dive(0.5);
      assertThat(bearingOffDeg()).isCloseTo(0.0, within(15.0));
      assertThat(Math.toDegrees(truth().rates().z())).isCloseTo(0.0, within(15.0));
    }
  }

  @Test
  void objects_cameraFails_thrustersAreLetGo() {
    start(true);
    dive(5.0);
    assertThat(dive.thrusters.keySet()).anySatisfy(name -> assertThat(isDriven(name)).isTrue());
    sees = false;
    dive(6.0);
    assertThat(isReached()).isFalse();
    assertThat(dive.thrusters.keySet()).allSatisfy(name -> assertThat(isDriven(name)).isFalse());
  }

  @Test
  void sensedState_velocityLogFails_thrustersAreLetGoAlthoughTheBuoyIsSeen() {
    start(true);
    dive.control.kill();
    variables(true);
    dive.control = dive.kit.with("SENSES MOTION", true).start(AllocatingControl::new);
    hasVelocityLog = true;
    dive(4.0);
    assertThat(dive.thrusters.keySet()).anySatisfy(name -> assertThat(isDriven(name)).isTrue());
    hasVelocityLog = false;
    dive(3.5);

    assertThat(isReached()).isFalse();
    assertThat(dive.thrusters.keySet()).allSatisfy(name -> assertThat(isDriven(name)).isFalse());
  }

  @Test
  void swap_plannerAndControlWithoutState_theApproachGoesOn() {
    start(true);
    dive(4.0);
    dive.kit.withoutVariables();
    planner = dive.kit.swap(planner, PathPlanner::new);
    dive(1.0);
    variables(true);
    dive.control = dive.kit.swap(dive.control, AllocatingControl::new);
    keepsFacing(6);
    dive(45.0);

    assertThat(dive.kit.published(Channels.STATE)).isEmpty();
    assertThat(isReached()).isTrue();
    assertThat(nearestM()).isBetween(0.5, WITHIN_M);
  }

  @Test
  void state_comesAndGoes_controlChangesOverAndBack() {
    start(true);
    dive(3.0);
    assertThat(dive.control.isStateless()).isTrue();
    sees = false;
    planner.kill();
    dive.target = Point.of(0.0, 0.0, 10.0);
    dive.dive(20.0);
    assertThat(dive.control.isStateless()).isFalse();
    assertThat(dive.worstM(2.0)).isLessThan(0.2);
  }
}
