package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScorer;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.score.WaypointResult;

/** Two waypoints, the second north of the first; the vehicle is about 10 m east of their line. */
class RunRecordTest {
  private static final double EAST_DEG = 9.0e-5;

  private final List<TrackSample> samples = new ArrayList<>();
  private final RunRecord record =
      new RunRecord(
          new RunPlan(
              Domain.GROUND,
              Optional.empty(),
              List.of(place("a", 0.0, 1.0), place("b", 0.01, 101.0))),
          new Geodetic(0.0, 0.0, 0.0),
          samples::add);

  private static RunPlan.Waypoint place(String name, double latitudeDeg, double withinM) {
    return new RunPlan.Waypoint(
        name, 0.0, latitudeDeg, OptionalDouble.empty(), withinM, OptionalDouble.empty());
  }

  private OptionalDouble crossTrackM(GoalInformation... goals) {
    record.received(new GoalList().goals(List.of(goals)).upcoming(List.of()));
    record.moment(samples.size(), EAST_DEG, 0.005, 0.0, 0.0, 1.0, "", Optional.empty());
    return samples.get(samples.size() - 1).crossTrackM();
  }

  @Test
  void moment_fromWaypointToWaypoint_isMeasuredFromTheirLine() {
    crossTrackM(new Waypoint().uid("a"));

    assertThat(crossTrackM(new Waypoint().uid("b"))).hasValueCloseTo(10.0, within(0.1));
    assertThat(crossTrackM(new Waypoint().uid("b"))).hasValueCloseTo(10.0, within(0.1));
  }

  private OptionalDouble crossTrackM(double latitudeDeg) {
    record.moment(samples.size(), EAST_DEG, latitudeDeg, 0.0, 0.0, 1.0, "", Optional.empty());
    return samples.get(samples.size() - 1).crossTrackM();
  }

  /** 0.01° are 1,106 m. */
  @Test
  void moment_onTheCircleOfAStation_isNoDeviationFromTheWayThere() {
    crossTrackM(new Waypoint().uid("a"));
    assertThat(crossTrackM(new Station().uid("b"))).hasValueCloseTo(10.0, within(0.1));

    assertThat(crossTrackM(0.0089)).hasValueCloseTo(10.0, within(0.1));
    assertThat(crossTrackM(0.0092)).isEmpty();
    assertThat(crossTrackM(0.0120)).isEmpty();
  }

  private static Landing landing(double latitudeDeg) {
    Landing landing = new Landing();
    landing.uid("b").referenceFrame(ReferenceFrame.GLOBAL).x(0.0).y(latitudeDeg);
    landing.horizontalThreshold(101.0);
    return landing;
  }

  private void update(String goals) {
    record.received(new MissionOrder().requestId("1").action(MissionAction.UPDATE).goals(goals));
  }

  private static Waypoint waypoint(double latitudeDeg, double thresholdM) {
    Waypoint at = new Waypoint().uid("b");
    at.referenceFrame(ReferenceFrame.GLOBAL).x(0.0).y(latitudeDeg).horizontalThreshold(thresholdM);
    return at;
  }

  @Test
  void plan_thresholdChangedByAnOrder_isJudgedByTheNewOne() {
    crossTrackM(waypoint(0.01, 101.0));
    update(
        "<mission><waypoint><name>b</name><horizontalThreshold>5</horizontalThreshold></waypoint></mission>");
    crossTrackM(waypoint(0.01, 5.0));
    crossTrackM(0.0099); // 15 m off
    assertThat(resultOfB().captured()).isFalse();

    crossTrackM(0.01);
    assertThat(resultOfB().captured()).isFalse(); // 10 m off

    update(
        "<mission><waypoint><name>b</name><horizontalThreshold>12</horizontalThreshold></waypoint></mission>");
    crossTrackM(waypoint(0.01, 12.0));
    crossTrackM(0.01);
    assertThat(resultOfB().captured()).isTrue();
  }

  @Test
  void goals_missionReplacedInFlight_areTheNewOnesAndThoseDone() {
    Set<String> planned = Set.of("a", "b");
    record.received(new Waypoint().uid("a").completed(true));
    MissionOrder order = new MissionOrder().requestId("7").action(MissionAction.REPLACE);
    record.received(order.goals("<mission><waypoint><name>c</name></waypoint></mission>"));
    assertThat(record.goals(planned)).isEqualTo(planned);

    record.received(new MissionOrderResult().requestId("7").accepted(true));
    assertThat(record.goals(planned)).containsExactly("a", "c");
    assertThat(record.leftOut()).containsExactly("b");
  }

  @Test
  void goals_replacementRefused_areThoseOfThePlan() {
    MissionOrder order = new MissionOrder().requestId("7").action(MissionAction.REPLACE);
    record.received(order.goals("<mission><waypoint><name>c</name></waypoint></mission>"));
    record.received(new MissionOrderResult().requestId("7").accepted(false));
    assertThat(record.goals(Set.of("a"))).containsExactly("a");
    assertThat(record.leftOut()).isEmpty();
  }

  private void order(String id, MissionAction action, String... goals) {
    String xml = "<mission>" + String.join("", goals) + "</mission>";
    record.received(new MissionOrder().requestId(id).action(action).goals(xml));
    record.received(new MissionOrderResult().requestId(id).accepted(true));
  }

  private static String named(String name) {
    return "<waypoint><name>" + name + "</name></waypoint>";
  }

  @Test
  void incomplete_goalsOfAReplacement_areThoseNotCompletedSince() {
    record.received(new Waypoint().uid("a").completed(true));
    order("7", MissionAction.REPLACE, named("a"), named("c"), named("d"));
    record.received(new Waypoint().uid("c").completed(true));

    assertThat(record.incomplete(Set.of("a", "b")))
        .containsExactly("goal \"a\" was not completed", "goal \"d\" was not completed");
    assertThat(record.completed(Set.of("a", "b"))).containsExactly("c");
  }

  @Test
  void incomplete_orderRepeated_keepsWhatWasCompletedSince() {
    order("7", MissionAction.REPLACE, named("c"));
    record.received(new Waypoint().uid("c").completed(true));
    order("7", MissionAction.REPLACE, named("c"));
    assertThat(record.incomplete(Set.of("a"))).isEmpty();
  }

  @Test
  void incomplete_goalWithoutAPlaceThatAReplacementDropped_doesNotCount() {
    order("7", MissionAction.REPLACE, named("c"));
    record.received(new Waypoint().uid("c").completed(true));
    assertThat(record.incomplete(Set.of("take off", "a", "b"))).isEmpty();
  }

  @Test
  void goals_insertedOnesWithoutNames_haveTheFirstFreeNumbers() {
    order("7", MissionAction.INSERT, "<waypoint/>", named("2"), "<waypoint/>");
    record.received(new Waypoint().uid("a").completed(true));
    assertThat(record.goals(Set.of("a", "1"))).containsExactlyInAnyOrder("a", "1", "2", "3", "4");
    assertThat(record.incomplete(Set.of("a")))
        .as("numbers free beside \"a\" alone")
        .containsExactly(
            "goal \"1\" was not completed",
            "goal \"2\" was not completed",
            "goal \"3\" was not completed");
  }

  @Test
  void goals_replacementWithoutNames_areTheirNumbersInTheFile() {
    order("7", MissionAction.REPLACE, "<home/>", named("c"), "<waypoint/>");
    assertThat(record.goals(Set.of("a"))).containsExactly("c", "2");
  }

  private WaypointResult resultOfB() {
    return RunScorer.score(
            record.plan(), record.track().samples(), new RunOutcome(0, false, List.of()))
        .waypoints()
        .get(1);
  }

  @Test
  void plan_currentLandingMovedByAnOrder_isJudgedThereAndFromThenOn() {
    crossTrackM(landing(0.01));
    crossTrackM(0.01);
    assertThat(resultOfB().captured()).isTrue();
    crossTrackM(0.03); // where it is to be moved
    update("<mission><landing><name>b</name></landing></mission>");
    crossTrackM(landing(0.03)); // on 0.005
    crossTrackM(0.02);

    assertThat(record.moved()).containsExactly("b");
    assertThat(resultOfB().captured()).isFalse();
    assertThat(resultOfB().missM().orElseThrow()).isCloseTo(1106.0, within(2.0));
    assertThat(legs()).containsExactly(-1, -1, -1, 1, 1);

    crossTrackM(0.0299);
    assertThat(resultOfB().captured()).isTrue();
  }

  @Test
  void plan_goalElsewhereWithoutAnOrderThatNamesIt_isThePlansForOthers() {
    update("<mission><landing><name>a</name></landing></mission>");
    crossTrackM(landing(0.03));

    assertThat(record.moved()).isEmpty();
    assertThat(record.plan().waypoints().get(1).latitudeDeg()).isEqualTo(0.01);
  }

  @Test
  void plan_updateThatMovesNothing_isThePlan() {
    update("<mission><landing><name>b</name></landing></mission>");
    crossTrackM(landing(0.01));

    assertThat(record.moved()).isEmpty();
    assertThat(legs()).containsExactly(1);
  }

  private static Waypoint done(String uid) {
    Waypoint report = new Waypoint().uid(uid);
    report.completed(true);
    return report;
  }

  private List<Integer> legs() {
    return record.track().samples().stream().map(TrackSample::leg).toList();
  }

  @Test
  void isMissionOver_resumedAfterItsLastGoal_isNoLongerOver() {
    crossTrackM();
    assertThat(record.isMissionOver()).isTrue();

    crossTrackM(new Waypoint().uid("a"));
    assertThat(record.isMissionOver()).isFalse();
  }

  @Test
  void received_secondOfTwoCurrentGoalsIsReported_wasTheTarget() {
    crossTrackM(new Waypoint().uid("a"), new Waypoint().uid("b"));
    record.received(done("b"));
    crossTrackM(new Waypoint().uid("a"));
    record.received(done("a"));
    record.received(done("a"));
    crossTrackM();

    assertThat(legs()).containsExactly(1, 0, 2);
    assertThat(record.leftOut()).isEmpty();
    assertThat(record.completed(Set.of("a", "b"))).containsExactlyInAnyOrder("a", "b");
  }

  @Test
  void received_goalGoneAfterAnotherWasDone_isLeftOut() {
    crossTrackM(new Waypoint().uid("a"), new Waypoint().uid("b"));
    record.received(done("b"));
    crossTrackM();

    assertThat(record.leftOut()).containsExactly("a");
  }

  @Test
  void landingsMissed_pursuedAndNotCompleted_areThoseOfThePlan() {
    crossTrackM(new Landing().uid("home")); // of a failsafe
    crossTrackM(new Landing().uid("a"));
    crossTrackM(new Landing().uid("b"));
    record.received(done("a"));

    assertThat(record.landingsMissed()).containsExactly("b");
  }

  @Test
  void received_goalGoneWithoutAReport_isNotLeftOut() {
    crossTrackM(new Waypoint().uid("a"), new Waypoint().uid("b"));
    crossTrackM(new Waypoint().uid("home"));
    record.received(done("home"));
    crossTrackM();

    assertThat(record.leftOut()).isEmpty();
  }

  @Test
  void moment_afterAGoalWithoutAPlace_hasNoLine() {
    crossTrackM(new Waypoint().uid("a"));

    assertThat(crossTrackM(new ObjectGoal().uid("barrel").objectType("barrel").within(2.0)))
        .isEmpty();
    assertThat(crossTrackM(new Waypoint().uid("b"))).isEmpty();
  }

  private void pursues(GoalInformation... goals) {
    record.received(new GoalList().goals(List.of(goals)).upcoming(List.of()));
  }

  private void completes(String goal) {
    record.received(new Waypoint().uid(goal).completed(true));
  }

  private static Waypoint twice() {
    Waypoint last = new Waypoint();
    last.uid("b").repeatFrom("a").repeatTimes(1);
    return last;
  }

  private void firstLap() {
    pursues(new Waypoint().uid("a"));
    completes("a");
    pursues(twice());
    completes("b");
    pursues(new Waypoint().uid("a"));
  }

  @Test
  void completed_missionThatRepeats_countsGoalsOnlyWhenItNoLongerPursuesThem() {
    Set<String> planned = Set.of("a", "b");
    firstLap();
    assertThat(record.completed(planned)).as("second lap").containsExactly("b");
    assertThat(record.unrepeated(planned)).containsExactly("a");
    completes("a");
    pursues(twice());
    assertThat(record.completed(planned)).containsExactly("a");
    completes("b");
    pursues();
    assertThat(record.completed(planned)).containsExactlyInAnyOrder("a", "b");
  }

  @Test
  void completed_failsafeEndsTheRepetition_goalsRemain() {
    firstLap();
    pursues(new Waypoint().uid("home"));
    completes("home");
    pursues();

    assertThat(record.completed(Set.of("a", "b"))).containsExactly("b");
  }

  @Test
  void completed_goalsOfALoop_countOnce() {
    pursues(new Waypoint().uid("a"));
    completes("a");
    pursues(new Waypoint().uid("b"));
    completes("b");
    pursues(new Waypoint().uid("a"));

    assertThat(record.completed(Set.of("a", "b"))).containsExactlyInAnyOrder("a", "b");
  }
}
