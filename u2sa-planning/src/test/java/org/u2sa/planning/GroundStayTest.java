package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.Vehicle;

class GroundStayTest {
  private static final List<GoalInformation> TAKE_OFF = List.of(new TakeOff().uid("up"));
  private static final List<GoalInformation> WAYPOINT = List.of(waypoint());
  private static final Plan UNDER_WAY =
      Plan.underWay(List.of(NavigationPoint.at(Point.of(1.0, 0.0, 0.0))));

  private boolean isAeroplane = true;
  private final GroundStay watch =
      new GroundStay(() -> new FlightVariables(3, 600, 5, 15, 40, 60, 0.5, 0.1), () -> isAeroplane);

  private static Waypoint waypoint() {
    return new Waypoint().uid("a").referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0);
  }

  private static Vehicle vehicle(double upM, double speedMps) {
    return vehicle(upM, speedMps, 0.0);
  }

  private static Vehicle vehicle(double upM, double speedMps, double sinkMps) {
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(0.0)
            .y(0.0)
            .z(-upM)
            .xDot(speedMps)
            .yDot(0.0)
            .zDot(sinkMps)
            .phi(0.0)
            .theta(0.0)
            .psi(0.0);
    state.timestamp(0L);
    return Vehicle.of(state).orElseThrow();
  }

  private void lead(double fromS, double toS) {
    for (double s = fromS; s <= toS; s += 0.1) {
      watch.lead(TAKE_OFF.get(0), UNDER_WAY, false, Math.round(s * 1e6));
    }
  }

  @Test
  void stays_beforeItWasLedForASecond_onlyAircraftDo() {
    assertThat(watch.stays()).isTrue();
    isAeroplane = false;
    assertThat(watch.stays()).isFalse();
    watch.heedGoals(new GoalList().goals(TAKE_OFF));
    watch.heedGoals(new GoalList().goals(WAYPOINT));
    assertThat(watch.stays()).isTrue();

    lead(0.0, 0.8);
    assertThat(watch.stays()).isTrue();
    lead(0.9, 1.1);
    assertThat(watch.stays()).isFalse();
  }

  @Test
  void stays_aeroplaneThatIsLedButStands_untilItIsFast() {
    lead(0.0, 9.0);
    watch.see(vehicle(0.0, 4.0));
    assertThat(watch.stays()).isTrue();

    watch.see(vehicle(0.0, 6.0));
    assertThat(watch.stays()).isFalse();
  }

  @Test
  void isBack_goalsLeadHomeWhileOnTheGround_untilItHasLeft() {
    watch.heedGoals(new GoalList().goals(WAYPOINT));
    assertThat(watch.isBack()).isFalse();
    watch.heedGoals(new GoalList().goals(WAYPOINT).returning(true));
    assertThat(watch.isBack()).isTrue();

    watch.see(vehicle(0.0, 6.0));
    assertThat(watch.isBack()).isFalse();
  }

  @Test
  void points_multirotorLedBeforeItLeft_straightDownUntilDisarmed() {
    isAeroplane = false;
    assertThat(watch.points(vehicle(0.0, 0.0))).isEmpty();
    lead(0.0, 0.5);
    watch.hold();
    assertThat(watch.points(vehicle(0.0, 0.0)))
        .singleElement()
        .satisfies(down -> assertThat(down.point().z()).isEqualTo(1.0));

    watch.heed(new ArmingState().armed(false));
    assertThat(watch.points(vehicle(0.0, 0.0))).isEmpty();
  }

  @Test
  void stays_ledWhileNotArmedOrWithAPause_isOnTheGround() {
    watch.heed(new ArmingState().armed(false));
    lead(0.0, 5.0);
    watch.heed(new ArmingState().armed(true));
    lead(5.1, 5.8);
    watch.hold();
    lead(9.0, 9.8);

    assertThat(watch.stays()).isTrue();
  }

  @Test
  void stays_fastWithoutBeingLedOrFlownByHand_hasLeft() {
    watch.see(vehicle(0.0, 4.0));
    assertThat(watch.stays()).isTrue();
    watch.see(vehicle(0.0, 6.0));
    assertThat(watch.stays()).isFalse();

    watch.lead(
        new Landing(), new Plan(List.of(), Plan.Progress.COMPLETED, "stands"), false, 9_000_000L);
    assertThat(watch.stays()).isTrue();
    watch.flownByHand();
    assertThat(watch.stays()).isFalse();
  }

  @Test
  void hold_multirotorTouchesDown_staysUntilItIsLedForASecondAgain() {
    isAeroplane = false;
    watch.heedGoals(new GoalList().goals(TAKE_OFF));
    lead(0.0, 2.0);
    watch.hold();
    assertThat(watch.stays()).isFalse();

    watch.lead(new Landing().uid("down"), UNDER_WAY, true, 3_000_000L);
    watch.hold();
    assertThat(watch.stays()).isTrue();
    assertThat(watch.points(vehicle(0.3, 0.0)).get(0).point().z()).isEqualTo(1.0);

    lead(4.0, 5.2);
    assertThat(watch.stays()).isFalse();
  }

  @Test
  void raised_lowOverTheGroundItTookOffFrom_isAtTheMinimumHeight() {
    watch.see(vehicle(100.0, 0.0));
    watch.see(vehicle(111.0, 0.5)); // in a head wind

    assertThat(watch.raised(vehicle(110.0, 20.0).place()).upM()).hasValue(140.0);
    assertThat(watch.raised(vehicle(150.0, 20.0).place()).upM()).hasValue(150.0);
    assertThat(((Waypoint) watch.raised(waypoint(), vehicle(110.0, 20.0))).z()).hasValue(-140.0);
    assertThat(watch.raised(waypoint().z(-5.0), vehicle(110.0, 20.0)))
        .isEqualTo(waypoint().z(-5.0));
    assertThat(watch.raised(waypoint(), vehicle(150.0, 20.0))).isEqualTo(waypoint());
    GoalInformation station = new Station().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0);
    assertThat(((Station) watch.raised(station, vehicle(110.0, 20.0))).z()).hasValue(-140.0);
    isAeroplane = false;
    assertThat(watch.raised(waypoint(), vehicle(110.0, 20.0))).isEqualTo(waypoint());
  }

  @Test
  void raised_startedInTheAir_isUnchanged() {
    watch.see(vehicle(100.0, 20.0));

    assertThat(watch.raised(vehicle(110.0, 20.0).place()).upM()).hasValue(110.0);
  }

  @Test
  void stays_afterALandingOrDisarmed_untilItIsLedForASecondAgain() {
    isAeroplane = false;
    watch.heedGoals(new GoalList().goals(TAKE_OFF));
    lead(0.0, 2.0);
    watch.lead(
        new Landing(), new Plan(List.of(), Plan.Progress.COMPLETED, "stands"), false, 3_000_000L);
    lead(4.0, 4.2);
    assertThat(watch.stays()).isTrue();
    lead(4.3, 5.2);
    assertThat(watch.stays()).isFalse();

    watch.heed(new ArmingState().armed(false));
    watch.heed(new ArmingState().armed(true));
    assertThat(watch.stays()).isTrue();
    watch.see(vehicle(50.0, 20.0)); // in the air
    assertThat(watch.stays()).isFalse();
  }

  private Optional<List<Double>> climb(GoalInformation goal, double upM) {
    return watch
        .climb(Optional.ofNullable(goal), vehicle(upM, 20.0), 60.0)
        .map(point -> List.of(point.point().x(), point.point().z()));
  }

  @Test
  void climb_holdsOrLeavesALandingWhileLow_straightAheadToHalfTheMinimumHeight() {
    GoalInformation landing = new Landing().uid("down");
    watch.see(vehicle(100.0, 0.0));
    watch.see(vehicle(103.0, 20.0));
    watch.lead(landing, UNDER_WAY, false, 3_000_000L);

    assertThat(climb(landing, 109.0)).isEmpty();
    assertThat(climb(waypoint(), 109.0)).hasValue(List.of(60.0, -31.0));
    watch.lead(waypoint(), UNDER_WAY, false, 4_000_000L);
    assertThat(climb(waypoint(), 119.0)).hasValue(List.of(60.0, -21.0));
    assertThat(climb(waypoint(), 121.0)).isEmpty();
    assertThat(climb(waypoint(), 119.0)).isEmpty(); // a mission may descend below
    assertThat(climb(null, 119.0)).isPresent();
  }

  @Test
  void climb_landingIsGivenUpWhileItSinks_straightAheadUntilItSinksNoMore() {
    Plan givenUp = new Plan(UNDER_WAY.points(), Plan.Progress.ABANDONED, "");
    watch.see(vehicle(100.0, 0.0));
    watch.see(vehicle(103.0, 20.0));
    Vehicle sinking = vehicle(125.0, 20.0, 3.0);
    for (Optional<GoalInformation> next :
        List.of(Optional.<GoalInformation>of(waypoint()), Optional.<GoalInformation>empty())) {
      watch.lead(new Landing().uid("down"), givenUp, false, 3_000_000L);
      if (next.isEmpty()) {
        watch.hold();
      }
      assertThat(watch.climb(next, sinking, 60.0)).isPresent();
      next.ifPresent(to -> watch.lead(to, UNDER_WAY, false, 4_000_000L));
      assertThat(watch.climb(next, sinking, 60.0)).isPresent();
      assertThat(watch.climb(next, vehicle(124.0, 20.0), 60.0)).isEmpty();
      watch.hold();
      assertThat(watch.climb(next, sinking, 60.0)).isEmpty(); // it descends, or a gust
    }
  }

  @Test
  void climb_takeOffOrAWaypointAfterIt_isEmpty() {
    watch.see(vehicle(100.0, 0.0));
    watch.see(vehicle(103.0, 20.0));
    lead(0.0, 2.0);
    assertThat(climb(TAKE_OFF.get(0), 109.0)).isEmpty();

    watch.lead(
        TAKE_OFF.get(0), new Plan(List.of(), Plan.Progress.COMPLETED, ""), false, 3_000_000L);
    assertThat(climb(waypoint(), 109.0)).isEmpty();
    isAeroplane = false;
    assertThat(climb(null, 109.0)).isEmpty();
  }
}
