package org.u2sa.planning.rightofway;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.rightofway.RightOfWayVariables.Rules;

/** Decisions of a boat northbound at 1.5 m/s that meets vessels in 100 s. */
class RightOfWayTest {
  private static final double MPS = 1.5;
  private static final RightOfWayVariables SETTINGS =
      new RightOfWayVariables(Rules.COLREGS, 20.0, 240.0, 120.0, 60.0, 35.0);

  private final List<String> said = new ArrayList<>();
  private final RightOfWay rules = new RightOfWay(() -> SETTINGS, said::add);
  private double nowS;

  private static OwnShip own(double northM, double eastM, double courseDeg, double wantedDeg) {
    double course = Math.toRadians(courseDeg);
    return new OwnShip(
        northM,
        eastM,
        MPS * Math.cos(course),
        MPS * Math.sin(course),
        Math.toRadians(wantedDeg),
        MPS,
        new OwnShip.Limits(1.0, Math.toRadians(15.0), 0.3, 1.0, 0.0));
  }

  /** A vessel that is where the boat would be after some time. */
  private static Target meeting(String name, double courseDeg, double mps, double afterS) {
    double course = Math.toRadians(courseDeg);
    double north = mps * Math.cos(course);
    double east = mps * Math.sin(course);
    return new Target(name, (MPS - north) * afterS, -east * afterS, north, east, 2.0, 0.5, 0.02);
  }

  private Optional<CourseOrder> decide(OwnShip own, Target... targets) {
    return decide(own, course -> true, targets);
  }

  /** The decision after the seconds that a condition has to last. */
  private Optional<CourseOrder> decide(OwnShip own, DoublePredicate isOpen, Target... targets) {
    Optional<CourseOrder> decided = Optional.empty();
    for (int i = 0; i < 5; i++) {
      nowS += 0.6;
      decided = rules.decide(own, List.of(targets), isOpen, nowS);
    }
    return decided;
  }

  private static double changeDeg(Optional<CourseOrder> manoeuvre) {
    return Math.toDegrees(manoeuvre.orElseThrow().changeRad());
  }

  @Test
  void decide_noVessel_goesToItsGoal() {
    assertThat(decide(own(0, 0, 0, 0))).isEmpty();
    assertThat(rules.remark()).isEmpty();
  }

  @Test
  void decide_vesselThatPassesFarOff_isNoEncounter() {
    Target far = new Target("A", 300, 80, -MPS, 0, 2, 0.5, 0.02);

    assertThat(decide(own(0, 0, 0, 0), far)).isEmpty();
    assertThat(rules.remark()).isEmpty();
  }

  @Test
  void decide_headOn_altersClearlyToStarboardAndSaysForWhom() {
    Optional<CourseOrder> decided = decide(own(0, 0, 0, 0), meeting("A", 180, MPS, 100));

    assertThat(changeDeg(decided)).isBetween(30.0, 60.0);
    assertThat(rules.remark()).isEqualTo("\"A\": head-on, gives way (rule 14)");
    assertThat(said).last().asString().contains("\"A\" (rule 14)").contains("to starboard");
  }

  @Test
  void decide_crossingFromStarboard_passesAstern() {
    Target target = meeting("A", 270, MPS, 100);
    OwnShip own = own(0, 0, 0, 0);
    Optional<CourseOrder> decided = decide(own, target);

    assertThat(changeDeg(decided)).isBetween(30.0, 90.0);
    Approach after = own.approach(target, decided.get().courseRad(), MPS);
    assertThat(after.crossesAheadM(target, 300.0)).isInfinite();
    assertThat(after.distanceM(after.closestS())).isGreaterThan(23.0);
  }

  @Test
  void decide_crossingFromPort_standsOnUntilTheOtherShouldHaveActed() {
    assertThat(decide(own(0, 0, 0, 0), meeting("A", 90, MPS, 100))).isEmpty();
    assertThat(rules.remark()).isEqualTo("\"A\": crossing, stands on (rule 15, 17)");

    Optional<CourseOrder> late = decide(own(0, 0, 0, 0), meeting("A", 90, MPS, 55));

    assertThat(changeDeg(late)).isBetween(30.0, 180.0); // not to port: rule 17(c)
    assertThat(said).anyMatch(line -> line.contains("\"A\" does not give way"));
    assertThat(late.get().reason()).contains("17(a)(ii)");
  }

  @Test
  void decide_vesselThatGivesWayInTime_isNotActedFor() {
    decide(own(0, 0, 0, 0), meeting("A", 90, MPS, 100));
    Target slowed = meeting("A", 90, MPS, 55).after(-30.0);

    assertThat(decide(own(0, 0, 0, 0), slowed)).isEmpty();
  }

  @Test
  void decide_slowVesselAhead_isPassedOnEitherSide() {
    Optional<CourseOrder> decided = decide(own(0, 0, 0, 0), meeting("A", 0, 0.6, 100));

    assertThat(Math.abs(changeDeg(decided))).isBetween(30.0, 60.0);
    assertThat(rules.remark()).contains("overtaking");
  }

  @Test
  void decide_fastVesselAstern_isStoodOnFor() {
    assertThat(decide(own(0, 0, 0, 0), meeting("A", 5, 2.5, 100))).isEmpty();
    assertThat(rules.remark()).contains("being overtaken, stands on");
  }

  @Test
  void decide_rule_isKeptWhenTheBearingChanges() {
    decide(own(0, 0, 0, 0), meeting("A", 270, MPS, 100));
    decide(own(0, 0, 90, 0), meeting("A", 180, MPS, 80));

    assertThat(rules.remark()).contains("crossing, gives way");
  }

  @Test
  void decide_manoeuvre_isKeptWhileItIsSafeAndEndsWhenTheCourseIsFree() {
    Target target = meeting("A", 180, MPS, 100);
    double course = changeDeg(decide(own(0, 0, 0, 0), target));
    double north = 30.0 * MPS * Math.cos(Math.toRadians(course));
    double east = 30.0 * MPS * Math.sin(Math.toRadians(course));

    Optional<CourseOrder> later = decide(own(north, east, course, -5), target.after(30.0));
    Optional<CourseOrder> past = decide(own(2 * north, 2 * east, course, -5), target.after(130.0));

    assertThat(Math.toDegrees(later.orElseThrow().courseRad())).isCloseTo(course, within(1.0e-6));
    assertThat(past).isEmpty();
  }

  @Test
  void decide_vesselsAheadAndToStarboard_areBothGivenWayTo() {
    OwnShip own = own(0, 0, 0, 0);
    Target one = meeting("A", 180, MPS, 100);
    Target two = meeting("B", 225, MPS, 100);
    CourseOrder decided = decide(own, one, two).orElseThrow();

    assertThat(decided.changeRad()).isPositive();
    for (Target each : List.of(one, two)) {
      Approach after = own.approach(each, decided.courseRad(), MPS * decided.speedShare());
      assertThat(after.distanceM(Math.max(0.0, after.closestS()))).isGreaterThan(23.0);
    }
    assertThat(rules.remark()).contains("\"A\": head-on").contains("\"B\": crossing, gives way");
  }

  @Test
  void decide_noCourseIsOpen_slowsDown() {
    Optional<CourseOrder> decided =
        decide(
            own(0, 0, 0, 0),
            course -> Math.abs(course) < 0.1, // a channel
            meeting("A", 270, MPS, 100));

    assertThat(decided.orElseThrow().speedShare()).isLessThan(1.0);
    assertThat(changeDeg(decided)).isZero();
  }

  @Test
  void decide_standsOnWhenItsWayTurns_holdsItsCourse() {
    decide(own(0, 0, 0, 0), meeting("A", 90, MPS, 100));
    Optional<CourseOrder> held = decide(own(0, 0, 0, 50), meeting("A", 90, MPS, 95));

    assertThat(Math.toDegrees(held.orElseThrow().courseRad())).isCloseTo(0.0, within(1.0));
    assertThat(held.get().reason()).contains("stands on for \"A\"");
  }

  @Test
  void decide_lostTrack_isKeptClearOfForAWhile() {
    decide(own(0, 0, 0, 0), meeting("A", 180, MPS, 100));

    assertThat(decide(own(0, 0, 35, 0))).isPresent();
    nowS += 30.0;
    decide(own(0, 0, 35, 0));
    assertThat(rules.remark()).isEmpty();
  }

  @Test
  void decide_sameTracks_decidesTheSame() {
    Target target = meeting("A", 180, MPS, 100);
    CourseOrder first = decide(own(0, 0, 0, 0), target).orElseThrow();
    RightOfWay again = new RightOfWay(() -> SETTINGS, line -> {});
    Optional<CourseOrder> second = Optional.empty();
    for (int i = 1; i <= 5; i++) {
      second = again.decide(own(0, 0, 0, 0), List.of(target), course -> true, 0.6 * i);
    }

    assertThat(second).contains(first);
  }
}
