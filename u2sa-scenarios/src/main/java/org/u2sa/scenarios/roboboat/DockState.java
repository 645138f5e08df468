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
 * {@link DockBoat}: along the line to the berth until the dock holds the boat; another attempt if
 * it is off the line before the entrance.
 */
final class DockState extends StationTaskState {
  private static final double ALIGNED_RAD = Math.toRadians(30.0);
  private static final double AHEAD_M = 1.5; // of the point on the line to steer to
  private static final double ENTER_MPS =
      1.1; // slower, a current from the side would turn the bow off the line too far
  private static final double FULL_SPEED_M = 3.0; // of a point at which control keeps that speed
  private static final double ENTRANCE_M = 2.5; // before the berth: last place to break off
  private static final double OFF_M = 0.6; // from the line
  private static final double BACK_M = 2.0; // from the station, to try again
  private static final double IN_M = 0.6; // from the berth
  private static final double STILL_MPS = 0.1;
  private static final double STILL_S = 2.0;
  private static final double LEFT_M = 3.5; // from the berth
  private static final double BACK_MPS = 0.7;
  private static final double LEAVE_MPS = 1.6; // before a current carries it to the fingers

  private static final double PATIENCE_S = 3.0;
  private static final double WIGGLE_RAD = Math.toRadians(15.0);
  private static final double WIGGLE_S = 20.0;

  private enum Phase {
    ALIGN,
    ENTER,
    BACK_OFF,
    LEAVE
  }

  private Phase phase = Phase.ALIGN;
  private long stillMicros; // since when, in the dock; Long.MIN_VALUE: not

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
    boolean isHeld = toGo < IN_M && speed(state) < STILL_MPS;
    if (phase == Phase.LEAVE && isHeld) {
      return Plan.underWay(List.of(astern(state)));
    }
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
    if (isStill(toGo, state)) {
      return Clock.seconds(micros(state) - stillMicros) < STILL_S
          ? Plan.underWay(List.of(NavigationPoint.at(Point.ORIGIN).speed(0.0).turn(0.0)))
          : new Plan(List.of(), Plan.Progress.COMPLETED, "docked");
    }
    return switch (phase) {
      case ENTER -> Plan.underWay(List.of(in(state, TaskSite.at(from, psi, along + AHEAD_M, 0.0))));
      case BACK_OFF -> back(goal, state, BACK_MPS);
      default -> Plan.underWay(List.of(facing(goal, state, psi)));
    };
  }

  /**
   * Out of the dock's hold, which lets the boat push back but not turn. If that takes long, control
   * may have wound up a turn while it entered, which leaves no thrust for reversing: a turn to
   * either side in turns works it off.
   */
  private NavigationPoint astern(StateInformation state) {
    stillMicros = stillMicros == Long.MIN_VALUE ? micros(state) : stillMicros;
    double heldS = Clock.seconds(micros(state) - stillMicros);
    double turn =
        heldS < PATIENCE_S ? 0.0 : WIGGLE_RAD * Math.sin(2.0 * Math.PI * heldS / WIGGLE_S);
    Point astern = Point.of(-LEFT_M, 0.0, 0.0);
    return NavigationPoint.at(astern).backwards(true).speed(LEAVE_MPS).turn(turn);
  }

  /** Towards a place on the line, without slowing down for it. */
  private NavigationPoint in(StateInformation state, Point place) {
    Point here = surroundings.here(state);
    double share = FULL_SPEED_M / Math.max(AHEAD_M, distance(here, place));
    return surroundings.straight(state, GateLine.between(here, place, share)).speed(ENTER_MPS);
  }

  private boolean isStill(double toGoM, StateInformation state) {
    boolean isStill = phase == Phase.ENTER && Math.abs(toGoM) < IN_M && speed(state) < STILL_MPS;
    if (!isStill) {
      stillMicros = Long.MIN_VALUE;
    } else if (stillMicros == Long.MIN_VALUE) {
      stillMicros = micros(state);
    }
    return isStill;
  }

  private static double speed(StateInformation state) {
    return Math.hypot(state.xDot().orElse(1.0), state.yDot().orElse(1.0));
  }
}
