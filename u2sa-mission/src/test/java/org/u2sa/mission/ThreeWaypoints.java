package org.u2sa.mission;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.testkit.ServiceKit;

/** Tests of a MissionManager with a mission of three waypoints. */
abstract class ThreeWaypoints {
  static final double DEFAULT_M = 7.0;

  final ServiceKit kit = new ServiceKit();
  @TempDir Path directory;
  Path file;

  @BeforeEach
  void writeMission() throws IOException {
    file = directory.resolve("three.xml");
    Files.writeString(
        file,
        "<mission><waypoint><x>1</x></waypoint><waypoint><x>2</x></waypoint><waypoint><x>3</x></waypoint></mission>");
    kit.with("MISSION", file.toString()).with("DEFAULT THRESHOLD", DEFAULT_M);
  }

  @AfterEach
  void close() {
    kit.close();
  }

  GoalList goals() {
    return kit.latest(Channels.GOALS).orElseThrow();
  }

  static Waypoint report(String uid) {
    return new Waypoint().uid(uid).x(1.0).horizontalThreshold(5.0);
  }

  boolean logged(String what) {
    return kit.log("MissionManager").stream().anyMatch(line -> line.contains(what));
  }

  List<String> current() {
    return goals().goals().stream().map(GoalInformation::uid).toList();
  }

  void complete(String uid) {
    Waypoint done = report(uid);
    done.completed(true);
    kit.publish(Channels.GOAL_REPORTS, done);
  }
}
