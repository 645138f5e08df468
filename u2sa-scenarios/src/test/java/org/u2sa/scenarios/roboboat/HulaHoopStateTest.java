package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.MarineObjects;
import org.u2sa.mission.Mission;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;
import org.u2sa.planning.seen.PlanarShape;

/** The station is at the origin, the hoop 4 m north of it. */
class HulaHoopStateTest {
  private static final double STEP_S = 0.1;

  @TempDir private Path directory;

  private final HulaHoopState hoops = new HulaHoopState(new Surroundings());
  private HulaHoop goal;
  private Plan last;
  private double endS;
  private int orders;

  /** A world of one hoop on the local plane. */
  private static final class Surroundings implements PlannerView {
    @Override
    public List<ObjectDescription> objects() {
      return List.of(MarineObjects.named("red hoop", 0.45).x(4.0).y(0.0).z(-1.0));
    }

    @Override
    public Point here(StateInformation state) {
      return Point.of(state.x().orElseThrow(), state.y().orElseThrow(), 0.0);
    }

    @Override
    public Point centre(ObjectDescription object, StateInformation state) {
      return object.center();
    }

    @Override
    public Point onPlane(ReferenceFrame frame, Point point, StateInformation state) {
      return point; // the goal's x and y are 0
    }

    @Override
    public NavigationPoint straight(StateInformation state, Point place) {
      return NavigationPoint.at(place.minus(here(state)));
    }

    @Override
    public List<PlanarShape> outlines(StateInformation state) {
      return List.of();
    }

    @Override
    public double courseRad(StateInformation state) {
      return state.psi().orElseThrow();
    }

    @Override
    public double missionS() {
      return 0.0;
    }

    @Override
    public void begin() {
      // no approach to reset
    }

    @Override
    public Step towards(Pursuit pursuit, Point place, double thresholdM, OptionalDouble speedMps) {
      return new Step(straight(pursuit.state(), place), Optional.empty());
    }
  }

  @BeforeEach
  void read() throws IOException {
    Path file = directory.resolve("mission.xml");
    Files.writeString(
        file,
        "<mission><hulaHoop><x>0</x><y>0</y><objectTypes>red hoop</objectTypes></hulaHoop></mission>");
    goal = (HulaHoop) Mission.load(file).goals().get(0);
  }

  /** Stays at the station with the bow in a direction, until the task is over. */
  private void stay(double headingRad) {
    hoops.enter(at(0.0, headingRad));
    boolean wasOrdered = false;
    for (double timeS = 0.0; timeS < 100.0; timeS += STEP_S) {
      last = hoops.plan(at(timeS, headingRad));
      boolean isOrdered =
          last.points().stream().anyMatch(point -> point.subsystem().equals("DART GUN"));
      orders += isOrdered && !wasOrdered ? 1 : 0;
      wasOrdered = isOrdered;
      endS = timeS;
      if (last.progress() != Plan.Progress.UNDER_WAY) {
        return;
      }
    }
  }

  private Pursuit at(double timeS, double headingRad) {
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(0.0);
    state.psi(headingRad).timestamp(Math.round(timeS * 1e6));
    return new Pursuit(goal, Optional.empty(), Optional.empty(), state);
  }

  @Test
  void plan_bowAtTheHoop_isOverAfterSixShotsAndReportsThem() {
    stay(0.0);

    HulaHoop report = (HulaHoop) last.changed().orElseThrow();
    assertThat(last.progress()).isEqualTo(Plan.Progress.COMPLETED);
    assertThat(orders).isEqualTo(6);
    assertThat(report.shots()).isEqualTo(6);
    assertThat(report.seconds()).isBetween(15.0, 30.0);
  }

  @Test
  void plan_bowNeverAtTheHoop_isOverAfter90SecondsWithoutAShot() {
    stay(0.5);

    HulaHoop report = (HulaHoop) last.changed().orElseThrow();
    assertThat(last.progress()).isEqualTo(Plan.Progress.COMPLETED);
    assertThat(endS).isBetween(89.9, 90.2);
    assertThat(report.shots()).isZero();
    assertThat(report.seconds()).isGreaterThanOrEqualTo(90.0);
    assertThat(orders).isZero();
  }
}
