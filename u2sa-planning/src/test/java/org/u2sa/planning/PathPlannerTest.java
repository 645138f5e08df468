package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** From a state to the point steered for: frames, ages, altitudes, and variables that change. */
class PathPlannerTest extends PlannedVehicle {
  @Test
  void state_withoutMission_givesNoNavigationPoint() {
    kit.start(PathPlanner::new);
    kit.publish(Channels.STATE, state(0, 0, 0));

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
  }

  @Test
  void state_waypointToTheRight_pointIsInBodyWithTheStatesTime() {
    kit.with("LOOK AHEAD", 5.0).start(PathPlanner::new);
    goals(waypoint("1", 0, 100).speed(3.0));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 0, 0));

    NavigationPoint point = kit.latest(Channels.NAVIGATION).orElseThrow();
    assertThat(point.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(point.subsystem()).isEqualTo("VEHICLE");
    assertThat(point.timestamp()).hasValue(100_000L);
    assertThat(point.speed()).hasValue(3.0);
    assertThat(point.point().x()).isCloseTo(0.0, within(1.0e-9));
    assertThat(point.point().y()).isCloseTo(-5.0, within(1.0e-9)); // BODY: y is to the left
    assertThat(point.point().z()).isZero(); // no z: no difference of altitude (thesis 4.6.2.3)
  }

  @Test
  void state_goalWithAView_theGimbalGetsItsPlace() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 100, 0).lookAt(Point.of(0.0, 50.0, 20.0)));
    kit.publish(Channels.STATE, state(0, 0, 0).z(0.0));

    NavigationPoint view =
        kit.<NavigationPoint>published(Channels.NAVIGATION).stream()
            .filter(point -> point.subsystem().equals("GIMBAL"))
            .findFirst()
            .orElseThrow();
    assertThat(view.point().y()).isCloseTo(-50.0, within(1.0e-9)); // to the right
    assertThat(view.point().z())
        .isCloseTo(20.0, within(1.0e-9)); // below: BODY is forward, left, down
  }

  @Test
  void state_goalWithAViewOfTheVehicle_turnsItThere() {
    kit.with("VIEW SUBSYSTEM", "VEHICLE").start(PathPlanner::new);
    goals(waypoint("1", 100, 0).lookAt(Point.of(0.0, 50.0, 20.0)));
    kit.publish(Channels.STATE, state(0, 0, 0.5).z(0.0));

    assertThat(kit.published(Channels.NAVIGATION)).hasSize(1);
    double turn = kit.latest(Channels.NAVIGATION).orElseThrow().turn().orElseThrow();
    assertThat(turn).isCloseTo(Math.PI / 2.0 - 0.5, within(1.0e-9));
  }

  @Test
  void state_rolledAndPitched_pointConvertsBackToWhereItIs() {
    kit.with("LOOK AHEAD", 50.0).start(PathPlanner::new);
    Waypoint goal = waypoint("1", 1000, 0).z(-200.0);
    goals(goal);
    StateInformation rolled = state(10, 0, 1.0).z(-100.0).phi(0.5).theta(0.2);
    kit.publish(Channels.STATE, rolled);

    Point ned =
        kit.latest(Channels.NAVIGATION).orElseThrow().in(ReferenceFrame.LOCAL_NED, rolled).point();
    assertThat(ned.x()).isCloseTo(60.0, within(1.0e-6));
    assertThat(ned.y()).isCloseTo(0.0, within(1.0e-6));
    assertThat(ned.z()).isCloseTo(-200.0, within(1.0e-6));
  }

  @Test
  void state_localEnu_isPlannedFromAsWell() {
    kit.with("LOOK AHEAD", 5.0).start(PathPlanner::new);
    goals(waypoint("1", 100, 0));
    kit.publish(
        Channels.STATE,
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(0.0)
            .y(0.0)
            .psi(Math.PI / 2.0));

    assertThat(point().x())
        .isCloseTo(5.0, within(1.0e-9)); // ENU: psi counts from east, so it heads north
    assertThat(point().y()).isCloseTo(0.0, within(1.0e-9));
  }

  @Test
  void state_utmWaypoint_isFoundOnTheEarth() {
    kit.with("LOOK AHEAD", 5.0).start(PathPlanner::new);
    Geodetic here = new Geodetic(9.0, 50.0, 0.0); // zone 32's central meridian: easting 500 km
    StateInformation utm =
        new StateInformation()
            .x(here.longitudeDeg())
            .y(here.latitudeDeg())
            .in(ReferenceFrame.utm(32, true));
    goals(
        new Waypoint()
            .uid("1")
            .referenceFrame(ReferenceFrame.utm(32, true))
            .x(utm.x().orElseThrow() + 100.0)
            .y(utm.y().orElseThrow())
            .horizontalThreshold(2.0));
    kit.publish(Channels.STATE, new StateInformation().x(9.0).y(50.0).psi(Math.PI / 2.0));

    assertThat(point().x()).isCloseTo(5.0, within(1.0e-3));
    assertThat(point().y()).isCloseTo(0.0, within(1.0e-3));
  }

  @Test
  void state_tooOld_givesNoNavigationPointAndIsCounted() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 100, 0));
    kit.advance(5.0);
    for (int i = 0; i < 3; i++) {
      StateInformation old = state(i, 0, 0);
      old.timestamp(3_000_000L + i);
      kit.publish(Channels.STATE, old);
    }

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
    kit.advance(0.3);
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().expired()).hasValue(3);
  }

  @Test
  void state_withoutHeading_givesNoNavigationPoint() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 100, 0));
    kit.publish(Channels.STATE, new StateInformation().x(1.0).y(2.0));

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
    assertThat(logged("state without x, y or psi")).isEqualTo(1);
  }

  @Test
  void state_onEarthButWaypointLocal_saysOnceAndInHealthThatTheyDoNotFit() {
    String words =
        "a place on a local plane (LOCAL_ENU, LOCAL_NED) cannot be navigated to by a state on the earth (GLOBAL, UTM)";
    kit.start(PathPlanner::new);
    goals(waypoint("1", 100, 0));
    for (int i = 0; i < 3; i++) {
      kit.publish(Channels.STATE, new StateInformation().x(8.0).y(50.0).psi(0.0));
      kit.advance(0.1);
    }

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
    assertThat(logged(words)).isEqualTo(1);
    kit.advance(1.0);
    assertThat(kit.<HealthReport>published(Channels.HEALTH))
        .extracting(report -> report.lastError().orElse(""))
        .anyMatch(error -> error.contains(words));
  }

  @Test
  void takeOff_onALocalPlaneButStateOnEarth_doesNotLeaveTheGround() {
    kit.start(PathPlanner::new);
    TakeOff takeOff = new TakeOff();
    takeOff.horizontalThreshold(2.0).uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    goals(takeOff.x(0.0).y(0.0).z(-30.0));
    for (int i = 0; i < 5; i++) {
      kit.publish(Channels.STATE, new StateInformation().x(8.0).y(50.0).z(100.0).psi(0.0));
      kit.advance(0.1);
    }

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
    assertThat(logged("cannot be navigated to by a state on the earth")).isEqualTo(1);
  }

  @Test
  void altitudeProfileLinear_pointIsOnTheSlope() {
    kit.with("ALTITUDE PROFILE", "LINEAR").with("LOOK AHEAD", 10.0).start(PathPlanner::new);
    goals(waypoint("1", 100, 0).z(-100.0));
    kit.publish(Channels.STATE, state(0, 0, 0).z(0.0));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(40, 0, 0).z(-30.0));

    assertThat(point().x()).isCloseTo(10.0, within(1.0e-9));
    assertThat(point().z())
        .isCloseTo(-20.0, within(1.0e-9)); // half way: 50 m up, of which 30 are done
  }

  @Test
  void configurationChange_ofLookAheadAndGuidance_countsFromTheNextState() {
    kit.with("LOOK AHEAD", 5.0).start(PathPlanner::new);
    goals(waypoint("1", 100, 0));
    kit.publish(Channels.STATE, state(0, 0, 0));
    change("LOOK AHEAD", "8");
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 0, 0));
    assertThat(point().x()).isCloseTo(8.0, within(1.0e-9));

    change("GUIDANCE", "DIRECT");
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 0, 0));
    assertThat(point().x()).isCloseTo(1.0, within(1.0e-9));
  }

  @Test
  void guidance_ofAnExtension_leadsAsItsLawSays() {
    kit.with("LOOK AHEAD", 5.0).with("GUIDANCE", "OFFSET").with("SIDE OFFSET", 2.0);
    kit.start(PathPlanner::new);
    goals(waypoint("1", 100, 0));
    kit.publish(Channels.STATE, state(0, 0, 0));

    assertThat(point().x()).isCloseTo(5.0, within(1.0e-9));
    assertThat(point().y()).isCloseTo(-2.0, within(1.0e-9)); // BODY: y to the left
  }

  @Test
  void guidance_thatNobodyProvides_isRefusedWithAllThereAre() {
    kit.with("GUIDANCE", "OFSET");
    assertThatThrownBy(() -> kit.start(PathPlanner::new))
        .hasMessageContaining("GUIDANCE")
        .hasMessageContaining("\"OFSET\" is not one of \"LINE\", \"DIRECT\", \"ILOS\", \"OFFSET\"");
  }

  private void change(String variable, String value) {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange().serviceName("PathPlanner").variableName(variable).value(value));
  }

  /** A class of an extension that brings no state for it. */
  private static final class Probe extends Waypoint {
    private static final MessageType<Probe> TYPE =
        Schema.of("Probe", Probe.class, Probe::new, Waypoint.TYPE).build();

    @Override
    public MessageType<Probe> type() {
      return TYPE;
    }
  }

  @Test
  void state_goalOfAClassWithoutAState_isPursuedAsItsAncestorAndThatIsTold() {
    PathPlanner planner = kit.start(PathPlanner::new);
    Probe probe = new Probe();
    probe.uid("a").referenceFrame(ReferenceFrame.LOCAL_NED).horizontalThreshold(1.0).x(9.0).y(0.0);
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(probe)));
    kit.publish(Channels.STATE, state(0, 0, 0));

    assertThat(kit.published(Channels.NAVIGATION)).isNotEmpty();
    assertThat(kit.log(planner.getServiceName()))
        .anyMatch(line -> line.contains("goal \"a\": a Probe is pursued as a Waypoint"));
  }
}
