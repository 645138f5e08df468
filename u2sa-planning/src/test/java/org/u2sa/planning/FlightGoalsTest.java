package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.testkit.ServiceKit;

/**
 * Goals of aircraft on a local plane, by a kinematic vehicle that goes to its navigation points.
 */
class FlightGoalsTest {
  private static final double STEP_S = 0.05;

  private final ServiceKit kit = new ServiceKit();
  private Point ned = Point.ORIGIN;
  private Point velocity = Point.ORIGIN;
  private Point wind = Point.ORIGIN;
  private double heading;
  private double roll;
  private boolean released;
  private boolean isStuck; // the release mechanism
  private int drops; // each after a second without a command
  private double commandedS = -10.0;
  private double tooHighM; // its altitude as known
  private Optional<Sphere> tower = Optional.empty();
  private double nearestM = Double.POSITIVE_INFINITY; // to the middle of the tower

  private void pursue(Waypoint goal) {
    goal.uid("G").referenceFrame(ReferenceFrame.LOCAL_NED);
    goal.horizontalThreshold(goal instanceof PayloadDrop ? 5.0 : 1.0);
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal)));
  }

  private void plane() {
    kit.with("TURN ACCELERATION", 6.0);
    kit.with("LOOK AHEAD", 50.0);
    kit.with("LOITER RADIUS", 100.0);
    kit.start(PathPlanner::new);
  }

  /** A route planner, and something that reaches from the ground to the sky. */
  private void tower(String planner, double north, double radiusM) {
    kit.with("PLANNER", planner).with("CLEARANCE", 2.0).with("PLANNING SPAN", 400.0);
    kit.with("VEHICLE WIDTH", 2.0).with("PLANNING CELL", 1.0).with("VERTICAL CLEARANCE", 500.0);
    Sphere body = new Sphere().radius(radiusM);
    body.uid("tower").objectType("tower").referenceFrame(ReferenceFrame.LOCAL_NED);
    body.x(north).y(1.0).z(0.0);
    tower = Optional.of(body);
  }

  /** One state and the answer to it, north, east, down of the vehicle. */
  private Point step(double speedMps) {
    kit.advance(STEP_S);
    Point through = new Attitude(0.0, 0.0, heading).bodyOf(velocity.minus(wind));
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(ned.x())
            .y(ned.y())
            .z(ned.z() - tooHighM)
            .zSigma(0.5 * tooHighM)
            .xDot(velocity.x())
            .yDot(velocity.y())
            .zDot(velocity.z())
            .phi(roll)
            .theta(0.0)
            .psi(heading)
            .fluidxDot(through.x())
            .fluidyDot(through.y())
            .fluidzDot(through.z());
    state.timestamp(kit.clock().micros());
    tower.ifPresent(this::passBy);
    ActuatorAnnouncement release = new ActuatorAnnouncement().minimum(0.0).maximum(100.0);
    kit.publish(
        Channels.ACTUATORS,
        release.actuatorName("BOTTLE").percentage(drops > 0 && isCommanded() ? 100.0 : 0.0));
    kit.publish(Channels.STATE, state);
    Point to = Point.ORIGIN;
    for (NavigationPoint point : kit.<NavigationPoint>published(Channels.NAVIGATION)) {
      if (point.timestamp().orElse(0L) != kit.clock().micros()) {
        continue;
      }
      if (point.subsystem().equals("VEHICLE")) {
        to = new Attitude(0.0, 0.0, heading).nedOf(point.point());
      } else {
        released |= point.subsystem().equals("BOTTLE");
        drops += isStuck || isCommanded() ? 0 : 1;
        commandedS = kit.nowS();
      }
    }
    double level = Math.hypot(to.x(), to.y());
    double sink = Math.max(-4.0, Math.min(4.0, to.z()));
    double mps = Math.min(speedMps, level / STEP_S);
    velocity =
        level < 1e-6
            ? Point.of(0.0, 0.0, sink)
            : Point.of(mps * to.x() / level, mps * to.y() / level, sink);
    if (mps > 1.0) {
      heading = Math.atan2(velocity.y(), velocity.x());
    }
    ned = ned.plus(velocity.times(STEP_S));
    return to;
  }

  private boolean isCommanded() {
    return kit.nowS() - commandedS < 1.0;
  }

  private void passBy(Sphere obstacle) {
    nearestM = Math.min(nearestM, Math.hypot(ned.x() - obstacle.x(), ned.y() - obstacle.y()));
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(obstacle)));
  }

  private List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }

  @Test
  void takeOff_aeroplane_leadsAlongItsHeadingUntilTheAltitude() {
    plane();
    heading = 0.5;
    pursue(new TakeOff().z(-60.0));

    Point first = step(20.0);
    assertThat(Math.atan2(first.y(), first.x())).isCloseTo(0.5, within(0.01));
    assertThat(first.z()).isCloseTo(-60.0, within(0.1));
    for (int i = 0; i < 600 && reports().isEmpty(); i++) {
      step(20.0);
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(ned.z()).isBetween(-61.0, -56.5);
    assertThat(Math.atan2(ned.y(), ned.x())).isCloseTo(0.5, within(0.02));
  }

  @Test
  void takeOff_multirotor_risesWhereItStands() {
    kit.start(PathPlanner::new);
    pursue(new TakeOff().z(-20.0));
    for (int i = 0; i < 300 && reports().isEmpty(); i++) {
      step(5.0);
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(0.1);
  }

  @Test
  void takeOff_aeroplaneThatNoLongerClimbs_isGivenUpAfterAMinute() {
    plane();
    pursue(new TakeOff().z(-60.0));
    double startedS = kit.nowS();
    while (reports().isEmpty() && kit.nowS() < startedS + 200.0) {
      step(20.0);
      ned = Point.of(ned.x(), ned.y(), Math.max(-25.0, ned.z()));
    }

    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason()).contains("given up: no higher than 25 m for a minute");
    assertThat(kit.nowS() - startedS).isBetween(60.0, 75.0);
  }

  /** A drop of which the wind blows across, scored by an integration of its own. */
  @ParameterizedTest
  @CsvSource({"0, 0, 20, 40", "5, 0, 20, 40", "-4, 6, 20, 40", "3, -7, 8, 40", "2, 3, 20, 200"})
  void payloadDrop_aeroplaneInWind_fallsOntoThePosition(
      double windNorth, double windEast, double terminalMps, double fromM) {
    plane();
    wind = Point.of(windNorth, windEast, 0.0);
    ned = Point.of(-600.0, 150.0, -fromM); // from 200 m the first pass is too high
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(
        new PayloadDrop()
            .payload("BOTTLE")
            .height(40.0)
            .terminalSpeed(terminalMps)
            .z(0.0)
            .x(0.0)
            .y(0.0));
    for (int i = 0; i < 6000 && !released; i++) {
      step(20.0);
    }
    assertThat(released).isTrue();
    assertThat(-ned.z()).isBetween(35.9, 44.1);

    Point falls = ned.plus(velocity.times(0.1)); // RELEASE DELAY
    Point v = velocity;
    for (double h = 0.001; falls.z() < 0.0; ) {
      Point air = v.minus(wind);
      v =
          v.plus(
              Point.of(0.0, 0.0, 9.80665)
                  .minus(air.times(9.80665 * air.distance() / (terminalMps * terminalMps)))
                  .times(h));
      falls = falls.plus(v.times(h));
    }
    assertThat(Math.hypot(falls.x(), falls.y())).isLessThan(3.0);
    for (int i = 0; i < 100 && reports().isEmpty(); i++) {
      step(20.0);
    }
    assertThat(reports().get(0).completed()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(doubles = {40.0, 2.0})
  void payloadDrop_multirotorAtAnotherHeight_isReleasedAtThatOfTheDrop(double fromM) {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -fromM);
    pursue(new PayloadDrop().payload("BOTTLE").height(10.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 1000 && !released; i++) {
      step(5.0);
    }
    assertThat(released).isTrue();
    assertThat(-ned.z()).isBetween(8.0, 12.0);
  }

  private PayloadDrop hoverAndDrop(String payload) {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -10.0);
    PayloadDrop drop = new PayloadDrop().payload(payload).height(10.0);
    drop.z(0.0).x(0.0).y(0.0);
    pursue(drop);
    return drop;
  }

  private GoalInformation report() {
    int known = reports().size();
    for (int i = 0; i < 1000 && reports().size() == known; i++) {
      step(5.0);
    }
    return reports().get(known);
  }

  @Test
  void payloadDrop_unknownPayload_isGivenUpNamingTheKnownOnes() {
    hoverAndDrop("BOTTEL");

    assertThat(report().abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow())
        .contains("\"BOTTEL\" is not a mechanism that reports its release; there: BOTTLE");
    assertThat(released).isFalse();
  }

  @Test
  void payloadDrop_mechanismThatDoesNotMove_isGivenUp() {
    isStuck = true;
    hoverAndDrop("BOTTLE");

    assertThat(report().abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("did not report a release");
    assertThat(released).isTrue();
  }

  @Test
  void payloadDrop_twoAtTheSamePlace_releasesTwice() {
    GoalInformation first = hoverAndDrop("BOTTLE");
    assertThat(report().completed()).isTrue();
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(first.copy().uid("H"))));

    assertThat(report().completed()).isTrue();
    assertThat(drops).isEqualTo(2);
  }

  @Test
  void payloadDrop_aeroplaneThatStaysTooHigh_isGivenUpWithTheReason() {
    plane();
    ned = Point.of(-300.0, 0.0, -90.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 10_000 && reports().isEmpty(); i++) {
      step(20.0);
      ned = Point.of(ned.x(), ned.y(), -90.0);
    }
    assertThat(released).isFalse();
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("given up: was 50 m too high");
  }

  @Test
  void payloadDrop_plannerSwappedAfterTheRelease_isCompletedAndNotFlownAgain() {
    kit.with("TURN ACCELERATION", 6.0).with("LOOK AHEAD", 50.0);
    PathPlanner first = kit.start(PathPlanner::new);
    ned = Point.of(-300.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 1000 && !released; i++) {
      step(20.0);
    }
    kit.swap(first, PathPlanner::new);
    for (int i = 0; i < 30; i++) {
      step(20.0);
    }
    assertThat(reports()).hasSize(1);
    assertThat(reports().get(0).completed()).isTrue();
  }

  @Test
  @Timeout(20)
  void goals_positionFarBeyondTheEarth_areLookedAtWithoutDelay() {
    tower("HYBRID", -100.0, 5.0);
    plane();
    ned = Point.of(0.0, 0.0, -100.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new Station().z(-100.0).x(9.0e8).y(0.0));
    step(20.0);
    pursue(new Landing().approach(9.0e8).z(0.0).x(500.0).y(0.0));
    step(20.0);
    assertThat(kit.published(Channels.NAVIGATION)).hasSize(2);
  }

  @Test
  void landing_aeroplane_descendsAlongItsLine() {
    plane();
    ned = Point.of(500.0, 800.0, -80.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    double lowestM = 80.0;
    for (int i = 0; i < 4000 && ned.z() < -1.0; i++) {
      step(20.0);
      lowestM = Math.abs(ned.y()) > 20.0 ? Math.min(lowestM, -ned.z()) : lowestM;
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(Math.abs(ned.y())).isLessThan(3.0);
    assertThat(ned.x()).isBetween(-60.0, 20.0);
    assertThat(lowestM).isGreaterThan(25.0); // not below the approach anywhere else
  }

  @Test
  void landing_directionChangedOnTheDescent_isFlownInTheNewOne() {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 200.0 && ned.z() < -25.0) {
      step(20.0);
    }
    assertThat(velocity.x()).isPositive();
    pursue(new Landing().approach(300.0).slope(0.1).psi(Math.PI).z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 400.0 && ned.z() < -15.0) {
      step(20.0);
    }
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0)); // too low
    while (kit.nowS() < 400.0 && ned.z() < -1.0) {
      step(20.0);
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(velocity.x()).isLessThan(-15.0);
    assertThat(Math.abs(ned.y())).isLessThan(3.0);
  }

  @ParameterizedTest
  @CsvSource({"-25, 200", "-12, 0"})
  void landing_positionMovesOnTheSlope_goesRoundForItOrStaysOnTheRunway(double down, double east) {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 200.0 && ned.z() < down) {
      step(20.0);
    }
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(100.0).y(200.0));
    double lowestMps = 0.0;
    while (kit.nowS() < 600.0 && ned.z() < -1.0) {
      step(20.0);
      lowestMps = ned.z() > -10.0 ? Math.max(lowestMps, Math.abs(velocity.y())) : lowestMps;
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(ned.y()).isCloseTo(east, within(3.0));
    assertThat(lowestMps).as("turns low").isLessThan(1.0);
  }

  /** The ground is below the position: control flies on above it. */
  @Test
  void landing_aeroplaneFliesOnLowBeyondThePosition_isGivenUpAfterThreeApproaches() {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    double farthestM = 0.0;
    while (kit.nowS() < 900.0 && reports().isEmpty()) {
      boolean isLow = ned.z() > -10.0;
      step(20.0);
      assertThat(isLow && Math.abs(ned.y()) > 20.0).as("turns low").isFalse();
      ned = Point.of(ned.x(), ned.y(), Math.min(ned.z(), -5.0));
      farthestM = Math.max(farthestM, ned.x());
    }

    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("flies on beyond the position");
    assertThat(kit.log("PathPlanner").stream().filter(line -> line.contains("trying again")))
        .hasSize(2);
    assertThat(farthestM).isBetween(200.0, 700.0);
  }

  @ParameterizedTest
  @CsvSource({"true, 600, true", "true, 1200, false", "false, 5, true", "false, 20, false"})
  void landing_standsAwayFromThePosition_isCompletedUpToABoundAndStays(
      boolean isAeroplane, double awayM, boolean isCompleted) {
    if (isAeroplane) {
      plane();
    } else {
      kit.with("AT END", "HOLD").start(PathPlanner::new);
    }
    ned = Point.of(0.0, 0.0, -1.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    step(0.5);
    for (int i = 0; i < 120 && reports().isEmpty(); i++) {
      ned = Point.of(awayM, 0.0, 0.0); // blown, or rolled
      velocity = Point.ORIGIN;
      step(0.0);
    }

    assertThat(reports().get(0).completed()).isEqualTo(isCompleted);
    assertThat(kit.log("PathPlanner"))
        .anyMatch(line -> line.contains("stands " + awayM + " m from its position"));
    kit.publish(Channels.GOALS, new GoalList());
    assertThat(step(0.0).z()).isNotNegative();
  }

  @ParameterizedTest
  @CsvSource({"12, 0", "0, -10"})
  void landing_positionMovesBelowADescent_isFlownToAfterRisingStraightUp(
      double north, double down) {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -8.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (ned.z() < -1.0) {
      step(2.0);
    }
    pursue(new Landing().z(down).x(north).y(0.0));
    double lowestAwayM = Double.POSITIVE_INFINITY;
    double highestM = 0.0;
    while (kit.nowS() < 120.0 && reports().isEmpty()) {
      step(5.0);
      boolean isAway = ned.x() > 0.1 && ned.x() < 10.9;
      lowestAwayM = isAway ? Math.min(lowestAwayM, -ned.z()) : lowestAwayM;
      highestM = Math.max(highestM, -ned.z());
      if (ned.z() > down && highestM > -down) {
        ned = Point.of(ned.x(), ned.y(), down); // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(lowestAwayM).isGreaterThan(2.9);
    assertThat(highestM).isBetween(3.0 - down, 4.1 - down);
    assertThat(ned.x()).isCloseTo(north, within(1.1));
  }

  @Test
  void landing_multirotor_descendsAboveItsPositionAndIsCompletedOnceItStands() {
    kit.start(PathPlanner::new);
    ned = Point.of(30.0, 0.0, -20.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 2000 && reports().isEmpty(); i++) {
      step(5.0);
      assertThat(ned.z() > -19.0 && Math.hypot(ned.x(), ned.y()) > 1.1).isFalse();
      if (ned.z() > 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports()).isNotEmpty();
    assertThat(reports().get(0).completed()).isTrue();
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(1.1);
  }

  @Test
  void landing_tippedOver_isAbandonedWithTheReason() {
    kit.start(PathPlanner::new);
    roll = 2.9;
    pursue(new Landing().z(0.0).x(0.0).y(0.0));

    for (int i = 0; i < 80 && reports().isEmpty(); i++) {
      step(0.0);
      velocity = Point.ORIGIN; // lies on the ground
      ned = Point.ORIGIN;
    }

    assertThat(reports()).hasSize(1);
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(kit.log("PathPlanner")).anyMatch(line -> line.contains("has tipped over"));
  }

  @Test
  void landing_multirotorWithHeading_turnsToItWhileItDescends() {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -12.0);
    heading = 0.5;
    pursue(new Landing().psi(2.0).z(0.0).x(0.0).y(0.0));
    step(5.0);
    double turn = kit.latest(Channels.NAVIGATION).orElseThrow().turn().orElseThrow();
    assertThat(turn).isCloseTo(1.5, within(1e-9));
  }

  @Test
  void landing_groundFarAboveItsPosition_isGivenUpAndStaysOnTheGround() {
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -12.0);
    pursue(new Landing().z(8.0).x(0.0).y(0.0));
    while (kit.nowS() < 90.0 && reports().isEmpty()) {
      step(5.0);
      if (ned.z() > 0.0) {
        ned = Point.ORIGIN; // the ground
        velocity = Point.ORIGIN;
      }
    }
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("stands 8.0 m above its position");
    kit.publish(Channels.GOALS, new GoalList());
    assertThat(step(5.0)).isEqualTo(Point.of(0.0, 0.0, 1.0));
  }

  @Test
  void landing_aeroplaneStandsOnHigherGround_isGivenUpWithTheHeight() {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(8.0).x(0.0).y(0.0));
    while (kit.nowS() < 200.0 && reports().isEmpty()) {
      step(ned.z() < 0.0 ? 20.0 : 0.0);
      if (ned.z() >= 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("stands 8.0 m above its position");
  }

  /** The landing's position is above the ground: it would be climbed to. */
  @Test
  void landing_completedAndAtEndHold_staysOnTheGround() {
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -20.0);
    pursue(new Landing().z(-1.0).x(0.0).y(0.0));
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(5.0);
      if (ned.z() > 0.0) {
        ned = Point.ORIGIN; // the ground
        velocity = Point.ORIGIN;
      }
    }
    assertThat(reports().get(0).completed()).isTrue();

    Point down = Point.of(0.0, 0.0, 1.0); // its control hovers where there is no point
    kit.publish(Channels.GOALS, new GoalList());
    assertThat(step(5.0)).isEqualTo(down);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD));
    assertThat(step(5.0)).isEqualTo(down);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.CONTINUE));
    pursue(new TakeOff().z(-20.0));
    assertThat(step(5.0).z()).isNegative();
  }

  /** As the estimate does while a receiver's first fixes are averaged. */
  @Test
  void takeOff_multirotorWhosePositionMovesNearTheGround_isLedStraightUp() {
    kit.start(PathPlanner::new);
    pursue(new TakeOff().z(-20.0));
    step(5.0);
    ned = Point.of(3.0, -2.0, ned.z());
    while (ned.z() > -1.7) {
      Point to = step(1.0);
      assertThat(Math.hypot(to.x(), to.y())).isLessThan(1e-9);
    }
    for (int i = 0; i < 300 && reports().isEmpty(); i++) {
      step(5.0);
    }
    assertThat(reports().get(0).completed()).isTrue();
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(0.1);
  }

  @Test
  void waypoint_insteadOfADescent_isFlownToAfterRisingStraightUp() {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -1.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    step(0.5);
    pursue(new Waypoint().x(30.0).y(0.0));
    while (ned.z() > -2.9) {
      Point to = step(1.0);
      assertThat(Math.hypot(to.x(), to.y())).isLessThan(1e-9);
    }
  }

  @Test
  @Timeout(20)
  void landing_altitudeUncertain_isSlowFromHigherOn() {
    tooHighM = 5.0; // with a sigma of half of it
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -20.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (ned.z() < 0.0) {
      step(5.0);
    }
    assertThat(velocity.z()).isLessThan(0.9);
  }

  @Test
  void waypoint_afterALanding_isFlownToAfterRisingStraightUp() {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -5.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(5.0);
      if (ned.z() > 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }
    Point from = ned;
    pursue(new Waypoint().z(-12.0).x(30.0).y(0.0));
    double lowestAwayM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 400; i++) {
      step(5.0);
      if (Math.hypot(ned.x() - from.x(), ned.y() - from.y()) > 0.3) {
        lowestAwayM = Math.min(lowestAwayM, -ned.z());
      }
    }
    assertThat(lowestAwayM).isBetween(1.9, 12.1);
    assertThat(ned.x()).isCloseTo(30.0, within(1.0));
  }

  /** A car with Ackermann steering has TURN ACCELERATION too, and must not be led into the air. */
  @ParameterizedTest
  @CsvSource({"0, 0", "100, -40"})
  void waypoint_withoutAltitude_isRaisedForAVehicleThatCannotStopOnly(
      double loiterRadiusM, double downM) {
    kit.with("TURN ACCELERATION", 1.0).with("LOITER RADIUS", loiterRadiusM);
    kit.start(PathPlanner::new);
    pursue(new Waypoint().x(30.0).y(0.0));

    assertThat(step(0.0).z()).isCloseTo(downM, within(0.1));
  }

  @Test
  void landing_slowTouchDown_isNotCompletedInTheAir() {
    kit.with("TOUCH DOWN SINK", 0.2).start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -2.5);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(0.2);
      if (ned.z() > 0.0) {
        ned = Point.ORIGIN; // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(ned.z()).isGreaterThan(-0.1);
  }

  /**
   * As a receiver's altitude may be: the vehicle stands, although its altitude says that it flies.
   */
  @Test
  void landing_altitudeTooHigh_isCompletedOnTheGround() {
    tooHighM = 5.0;
    kit.start(PathPlanner::new);
    ned = Point.of(8.0, 0.0, -2.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    double highestM = 0.0; // when completed
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(0.2); // still by its speed all the time
      highestM = -ned.z();
      if (ned.z() > 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(highestM).isLessThan(0.1);
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(1.1);
  }

  @Test
  void landing_multirotorLowerThanTheRoof_climbsAboveItFirst() {
    kit.start(PathPlanner::new);
    ned = Point.of(30.0, 0.0, -5.0);
    pursue(new Landing().x(0.0).y(0.0).z(-20.0)); // 20 m up
    double highestM = 0.0;
    for (int i = 0; i < 2000 && reports().isEmpty(); i++) {
      step(4.0);
      highestM = Math.max(highestM, -ned.z());
      boolean isOverTheRoof = Math.hypot(ned.x(), ned.y()) < 5.0;
      assertThat(isOverTheRoof && ned.z() > -19.0).as("below the roof at step %d", i).isFalse();
      if (isOverTheRoof && ned.z() > -20.0) {
        ned = Point.of(ned.x(), ned.y(), -20.0);
        velocity = Point.ORIGIN;
      }
    }

    assertThat(highestM).isBetween(22.0, 25.0);
    assertThat(reports().get(0).completed()).isTrue();
  }

  @Test
  void landing_towerBeforeTheMultirotor_isFlownAround() {
    tower("GRID", 60.0, 10.0);
    kit.start(PathPlanner::new);
    ned = Point.of(120.0, 0.0, -20.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 2000 && ned.z() < -1.0; i++) {
      step(5.0);
    }

    assertThat(nearestM).isGreaterThan(10.0);
    assertThat(ned.z()).isGreaterThan(-1.0);
  }

  @Test
  void payloadDrop_towerOnTheWay_isFlownAroundBeforeTheRelease() {
    tower("AIR", -500.0, 20.0);
    kit.with("PLANNED SPEED", 20.0).with("MIN SPEED", 15.0).with("MAX SPEED", 25.0);
    plane();
    ned = Point.of(-900.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 2000 && !released; i++) {
      step(20.0);
    }

    assertThat(nearestM).isGreaterThan(20.0);
    assertThat(released).isTrue();
  }
}
