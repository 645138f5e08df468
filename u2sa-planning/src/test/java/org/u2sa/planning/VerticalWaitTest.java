package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Sphere;

/** A multirotor that waits in its climb or descent, also close to what it waits for. */
class VerticalWaitTest extends VerticalFlight {
  private static final double SEPARATION_M = 20.0;

  private static Landing landing() {
    Landing landing = new Landing();
    landing.x(0.0).y(0.0).z(0.0);
    return landing;
  }

  /** Traffic that stands in the air. */
  private Sphere standing(double northM, double highM) {
    Sphere traffic = crossing(kit.nowS(), 0.0, highM, SEPARATION_M);
    traffic.x(northM);
    return traffic;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 4.0})
  void landing_waitsLowAboveACar_isGivenUpAndNotReportedAsLanded(double sigma) {
    sigmaM = sigma;
    clearanceM = 2.0 + sigma;
    start(25.0);
    GoalInformation report = pursue(landing(), 90.0, slab(0.0, 0.8));

    assertThat(lowestM).isBetween(2.0, 2.81 + sigma);
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).endsWith("in the way of the descent");
  }

  /** An inaccurate altitude: the vehicle is estimated below the top of what it waits above. */
  @Test
  void landing_startsInsideTheOutlineOfATower_staysThere() {
    start(16.0);
    GoalInformation report = pursue(landing(), 90.0, slab(0.0, 17.0));

    assertThat(lowestM).isGreaterThan(15.5);
    assertThat(report.abandoned()).isTrue();
  }

  @Test
  void takeOff_trafficStandsAboveWithinItsSeparation_isGivenUpOnTheGround() {
    start(0.0);
    GoalInformation report = pursue(new TakeOff().z(-30.0), 90.0, standing(0.0, 18.0));

    assertThat(highestM).isLessThan(0.5);
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).endsWith("in the way of the climb");
  }

  @Test
  void landing_trafficStandsBelowWithinItsSeparation_isGivenUpAboveIt() {
    start(25.0);
    GoalInformation report = pursue(landing(), 90.0, standing(0.0, 8.0));

    assertThat(lowestM).isGreaterThan(24.5);
    assertThat(report.abandoned()).isTrue();
  }

  @Test
  void landing_fromBelowStandingTraffic_isCompleted() {
    start(10.0);
    assertThat(pursue(landing(), 60.0, standing(0.0, 18.0)).completed()).isTrue();
  }

  /** Its altitude differs by an error of measurement. */
  @Test
  void takeOff_trafficIsParkedBeside_isCompleted() {
    start(0.0);
    Waypoint climb = new TakeOff().z(-30.0);
    assertThat(pursue(climb, 60.0, standing(15.0, 0.5)).completed()).isTrue();
  }

  @Test
  void takeOff_besideAWall_isCompleted() {
    start(0.0);
    assertThat(pursue(new TakeOff().z(-30.0), 60.0, slab(0.0, 12.0)).completed()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(doubles = {2.0, 2.2})
  void takeOff_besideABarrelAsHighAsWide_isCompletedLikeBesideAHigherOne(double heightM) {
    start(0.0);
    Cylinder barrel = new Cylinder().radius(1.0).height(heightM);
    barrel.uid("barrel").objectType("barrel").referenceFrame(ReferenceFrame.LOCAL_NED);
    barrel.x(1.2).y(0.0).z(-0.5 * heightM);
    assertThat(pursue(new TakeOff().z(-30.0), 60.0, barrel).completed()).isTrue();
  }

  /** It comes to the place from the side while the vehicle descends, and stops there. */
  @ParameterizedTest
  @ValueSource(doubles = {4.0, 8.0, 13.0})
  void landing_trafficStopsBelow_isNotSunkThrough(double highM) {
    start(25.0);
    begin(landing());
    double nearestM = Double.POSITIVE_INFINITY;
    while (kit.nowS() < 120.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      double awayM = Math.max(0.0, 80.0 - 8.0 * kit.nowS());
      Sphere other = standing(awayM, highM);
      other.motion().velocity(Point.of(awayM > 0.0 ? -8.0 : 0.0, 0.0, 0.0));
      nearestM = Math.min(nearestM, Math.hypot(awayM, upM - highM));
      step(0.0, other);
    }
    assertThat(nearestM).isGreaterThan(4.0);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().abandoned()).isTrue();
  }

  /** One after another comes towards the place; the vehicle never gets below them. */
  @Test
  void landing_trafficPassesAgainAndAgain_isGivenUpAfterItsPatience() {
    start(25.0);
    begin(landing());
    while (kit.nowS() < 420.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      Sphere other = standing(8.0 * (kit.nowS() % 7.0) - 60.0, 10.0);
      other.motion().velocity(Point.of(8.0, 0.0, 0.0));
      step(0.0, other);
    }
    GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
    assertThat(report.reason().orElseThrow()).endsWith("traffic is in the way of the descent");
    assertThat(kit.nowS()).isBetween(300.0, 400.0);
  }
}
