package org.u2sa.planning;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.testkit.ServiceKit;

/** Tests of a PathPlanner that is handed goals and states. */
abstract class PlannedVehicle {
  final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  static Waypoint waypoint(String name, double north, double east) {
    return new Waypoint()
        .uid(name)
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east)
        .horizontalThreshold(2.0);
  }

  static StateInformation state(double north, double east, double heading) {
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east)
        .psi(heading);
  }

  void goals(GoalInformation... goals) {
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(goals)).upcoming(List.of()));
  }

  Point point() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().point();
  }

  long logged(String what) {
    return kit.log("PathPlanner").stream().filter(line -> line.contains(what)).count();
  }
}
