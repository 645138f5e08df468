package org.u2sa.scenarios.roboboat;

import java.util.List;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;
import org.u2sa.scenarios.roboboat.gate.GateLine;

/**
 * {@link DockBoat}: follows the line to the berth until the boat lies still at the wall; tries
 * again if it is off the line in front of the entrance.
 */
final class DockState extends StationTaskState {
  private static final double ALIGNED_RAD = Math.toRadians(30.0);
  private static final double AHEAD_M = 1.5; // look-ahead along the line
  private static final double ENTER_MPS =
      1.1; // slower, the bow would be too far off the line in a cross current
  private static final double INSIDE_M = 0.9; // bow between the fingers
  private static final double TOUCH_MPS = 0.5;
  private static final double FULL_SPEED_M = 3.0; // distance to a point passed at that speed
  private static final double ENTRANCE_M = 2.5; // last distance to break off the approach
  private static final double OFF_M = 0.6; // cross-track distance
  private static final double BACK_M = 2.0; // distance from the station to try again
  private static final double IN_M = 0.6; // distance from the berth
  private static final double STILL_S = 5.0; // at rest, so the quadrotor finds the boat there
  private static final double SLIDES_M = 0.15; // more than the motion caused by waves
  private static final double TURNS_RAD = Math.toRadians(8.0);
  private static final double LEFT_M = 3.5; // distance from the berth
  private static final double BACK_MPS = 0.7;
  private static final double LEAVE_MPS = 1.6; // fast, so that the current does not push it aside

  private enum Phase {
    ALIGN,
    ENTER,
    BACK_OFF,
    LEAVE
  }

  private Phase phase = Phase.ALIGN;
  private long stillMicros; // since when at rest in the dock; Long.MIN_VALUE: not at rest
  private Point lay = Point.ORIGIN; // position relative to the station then: north, east
  private double layPsi;

  DockState(PlannerView surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return DockBoat.class;
  }

  @Override
  void begin(BoatTask task) {
    phase = ((DockBoat) task).leaves() ? Phase.LEAVE : Phase.ALIGN;
    stillMicros = Long.MIN_VALUE;
  }

  @Override
  boolean isFree() {
    return phase != Phase.ALIGN;
  }

  @Override
  Plan work(BoatTask task, Pursuit pursuit, double sinceS) {
    DockBoat goal = (DockBoat) task;
    StateInformation state = pursuit.state();
    double psi = goal.psi().orElse(0.0);
    Point from = station(goal, state);
    Point off = surroundings.here(state).minus(from);
    double along = off.x() * Math.cos(psi) + off.y() * Math.sin(psi);
    double aside = off.y() * Math.cos(psi) - off.x() * Math.sin(psi);
    double toGo = goal.way() - along;
    if (phase == Phase.LEAVE) {
      return toGo > LEFT_M
          ? new Plan(List.of(), Plan.Progress.COMPLETED, "left the dock")
          : back(goal, state, LEAVE_MPS);
    }
    double turn = Math.IEEEremainder(state.psi().orElseThrow() - psi, 2.0 * Math.PI);
    if (phase == Phase.ALIGN && Math.abs(turn) < ALIGNED_RAD) {
      phase = Phase.ENTER;
    } else if (phase == Phase.ENTER
        && Math.abs(aside) > OFF_M
        && Math.abs(toGo - ENTRANCE_M) < OFF_M) {
      phase = Phase.BACK_OFF;
    } else if (phase == Phase.BACK_OFF && along < BACK_M) {
      phase = Phase.ALIGN;
    }
    if (isStill(toGo, off, state) && Clock.seconds(micros(state) - stillMicros) > STILL_S) {
      return new Plan(List.of(), Plan.Progress.COMPLETED, "docked");
    }
    return switch (phase) {
      case ENTER ->
          Plan.underWay(List.of(in(state, TaskSite.at(from, psi, along + AHEAD_M, 0.0), toGo)));
      case BACK_OFF -> back(goal, state, BACK_MPS);
      default -> Plan.underWay(List.of(facing(goal, state, psi)));
    };
  }

  /** Goes towards a point on the line without slowing down for it. */
  private NavigationPoint in(StateInformation state, Point place, double toGoM) {
    Point here = surroundings.here(state);
    double share = FULL_SPEED_M / Math.max(AHEAD_M, here.flatDistanceTo(place));
    return surroundings
        .straight(state, GateLine.between(here, place, share))
        .speed(toGoM > INSIDE_M ? ENTER_MPS : TOUCH_MPS);
  }

  private boolean isStill(double toGoM, Point off, StateInformation state) {
    double psi = state.psi().orElseThrow();
    boolean isStill = phase == Phase.ENTER && Math.abs(toGoM) < IN_M;
    if (!isStill) {
      stillMicros = Long.MIN_VALUE;
    } else if (stillMicros == Long.MIN_VALUE
        || off.flatDistanceTo(lay) > SLIDES_M
        || Math.abs(Math.IEEEremainder(psi - layPsi, 2.0 * Math.PI)) > TURNS_RAD) {
      stillMicros = micros(state);
      lay = off;
      layPsi = psi;
    }
    return isStill;
  }
}
