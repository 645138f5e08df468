package org.u2sa.gcs.mavlink.command;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.gcs.mavlink.plan.PlanBook;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders.Answer;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.report.EscapedXml;

/** Changes what the vehicle does, through orders to its Mission Manager. */
final class ModeOrders {
  private static final double USUAL_THRESHOLD_M = 2.0;
  private static final double VERTICAL_THRESHOLD_M = 1.0;

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final PlanBook book;

  ModeOrders(VehicleStatus vehicle, VehicleOrders orders, PlanBook book) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.book = book;
  }

  void change(VehicleMode mode, Answer answer) {
    switch (mode) {
      case HOLD -> hold(answer);
      case MISSION -> mission(answer);
      case RETURN -> give(MissionAction.RETURN, Optional.empty(), answer);
      case LAND -> give(MissionAction.LAND, Optional.empty(), answer);
      case GO_TO, MANUAL -> answer.done(false, "expected a position to go to, or a driver");
    }
  }

  private void hold(Answer answer) {
    if (vehicle.current().isEmpty()) {
      answer.done(true, "the mission is over: the vehicle holds");
    } else {
      give(MissionAction.PAUSE, Optional.empty(), answer);
    }
  }

  /**
   * Resumes the mission with another Path Planner class.
   *
   * @param planner index of the class; empty: that of the mode Mission
   */
  void mission(Optional<Integer> planner, Answer answer) {
    if (planner.equals(vehicle.planners().running())) {
      mission(answer);
      return;
    }
    orders.plan(
        vehicle.planners(),
        planner,
        (swapped, why) -> {
          if (swapped) {
            mission(answer);
          } else {
            answer.done(false, why);
          }
        });
  }

  /** Resumes the mission; restarts it if it is over. */
  void mission(Answer answer) {
    if (vehicle.current().isEmpty()) {
      goTo(book.firstGoal(), answer);
    } else if (vehicle.mode() == VehicleMode.MISSION) {
      answer.done(true, "the mission is being pursued");
    } else {
      resume(vehicle.isHeldAside() ? 2 : 1, answer);
    }
  }

  /**
   * Needs two orders: the first ends a pause, the second returns from home or another place to the
   * mission.
   */
  private void resume(int times, Answer answer) {
    give(
        MissionAction.RESUME,
        Optional.empty(),
        (resumed, why) -> {
          if (!resumed) {
            goTo(book.firstGoal(), answer);
          } else if (times > 1) {
            resume(times - 1, answer);
          } else {
            answer.done(true, why);
          }
        });
  }

  /** Pursues a goal of the mission. */
  void goTo(Optional<String> goal, Answer answer) {
    if (goal.isEmpty()) {
      answer.done(false, "the mission has no such item");
    } else {
      give(MissionAction.GOTO, goal, answer);
    }
  }

  private void give(MissionAction action, Optional<String> goal, Answer answer) {
    MissionOrder order = new MissionOrder().action(action);
    goal.ifPresent(order::uid);
    orders.mission(order, answer);
  }

  /** Goes to a place and stays there; the mission can be resumed afterwards. */
  void goTo(Geodetic place, OptionalDouble altitudeM, OptionalDouble speed, Answer answer) {
    String uid = speed.isPresent() ? VehicleStatus.GO_TO_AT_SPEED : VehicleStatus.GO_TO;
    Waypoint goal =
        new Waypoint()
            .uid(uid)
            .x(place.longitudeDeg())
            .y(place.latitudeDeg())
            .horizontalThreshold(thresholdM());
    goal.nextIf(GoalResult.DONE, List.of());
    altitudeM.ifPresent(goal::z);
    if (altitudeM.isPresent() && vehicle.kind() != VehicleKind.PLANE) {
      goal.verticalThreshold(VERTICAL_THRESHOLD_M); // so that a copter climbs before it arrives
    }
    speed.ifPresent(goal::speed);
    orders.tell(Channels.GOAL_UPDATES, goal);
    give(MissionAction.GOTO, Optional.of(uid), answer);
  }

  /** Threshold of the mission's first waypoint, as a typical threshold for this vehicle. */
  private double thresholdM() {
    return vehicle.report().stream()
        .flatMap(report -> report.goals().stream())
        .filter(Waypoint.class::isInstance)
        .mapToDouble(goal -> ((Waypoint) goal).horizontalThreshold())
        .findFirst()
        .orElse(USUAL_THRESHOLD_M);
  }

  /** Sets the speed of the remaining goals. */
  void speed(double metresPerSecond, Answer answer) {
    StringBuilder goals = new StringBuilder("<mission>");
    vehicle
        .report()
        .ifPresent(
            report -> {
              for (GoalInformation goal : report.goals()) {
                boolean isOpen =
                    goal.type() == Waypoint.TYPE
                        && goal.result().isEmpty()
                        && !goal.uid().equals(VehicleStatus.HOME);
                if (isOpen) {
                  goals.append(
                      String.format(
                          Locale.ROOT,
                          "<waypoint><name>%s</name><speed>%.3f</speed></waypoint>",
                          EscapedXml.of(goal.uid()),
                          metresPerSecond));
                }
              }
            });
    orders.mission(
        new MissionOrder()
            .action(MissionAction.UPDATE)
            .file("a ground station's speed")
            .goals(goals.append("</mission>").toString()),
        answer);
  }
}
