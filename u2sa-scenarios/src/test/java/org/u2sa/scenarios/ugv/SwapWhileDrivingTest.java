package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.estimation.ComplementaryStateEstimator;
import org.u2sa.estimation.FusingStateEstimator;
import org.u2sa.estimation.PassThroughStateEstimator;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.planning.PathPlanner;
import org.u2sa.planning.VectorFieldPlanner;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.testkit.Repository;
import org.u2sa.world.WorldModeler;
import org.u2sa.world.xml.WorldFile;

/**
 * State Estimator, World Modeler and planner replaced while the ground vehicle drives (user story
 * 8): the mission continues within its tolerances, and the state does not leap.
 */
class SwapWhileDrivingTest {
  private static final int LOOP = 6;
  private static final double ENOUGH_S = 300.0;

  /** Waypoints are passed at 0.5 m by the estimate. */
  private static final double FARTHEST_M = 0.7;

  /** More than the vehicle's way since the state before: what a survey-grade receiver errs by. */
  private static final double LARGEST_LEAP_M = 0.15;

  private static final double FASTEST_MPS = 1.5;

  @TempDir private Path directory;

  /** How far states are apart beyond what the vehicle can have driven. */
  private static final class Leaps {
    private Optional<StateInformation> last = Optional.empty();
    private double largestM;

    void look(StateInformation state) {
      if (state.x().isEmpty()) {
        return;
      }
      last.ifPresent(
          before -> {
            Point apart = place(before).enuOf(place(state));
            long micros = state.timestamp().getAsLong() - before.timestamp().getAsLong();
            double beyondM = Math.hypot(apart.x(), apart.y()) - FASTEST_MPS * micros * 1e-6;
            largestM = Math.max(largestM, beyondM);
          });
      last = Optional.of(state);
    }

    private static Geodetic place(StateInformation state) {
      return new Geodetic(state.x().getAsDouble(), state.y().getAsDouble(), 0.0);
    }
  }

  /** Of a copy of the vehicle's files: a variable that is changed is changed in its file. */
  private UgvDrive start(String system, List<? extends ObjectDescription> obstacles, String file)
      throws IOException {
    for (String folder : List.of("config/ugv", "missions/ugv")) {
      Path copy = Files.createDirectories(directory.resolve(folder));
      try (Stream<Path> files = Files.list(Repository.root().resolve(folder))) {
        for (Path each : files.filter(Files::isRegularFile).toList()) {
          Files.copy(each, copy.resolve(each.getFileName()));
        }
      }
    }
    return new UgvDrive(
        directory.resolve("logs"),
        directory.resolve("config/ugv").resolve(system),
        new UgvDrive.Scene(3, GpsGrade.SURVEY, Hazards.none(), obstacles),
        true,
        (LaunchOptions options) -> {
          if (!file.isEmpty()) {
            options.override("WorldModeler", "WORLD", file);
          }
        });
  }

  private static void requireTheLoop(UgvDrive drive, Leaps leaps) throws Exception {
    drive.driveUntil("the loop", () -> drive.operator.goalsDone() == LOOP, ENOUGH_S);
    assertThat(drive.operator.answers()).isNotEmpty().containsOnly("done");
    assertThat(Collections.max(drive.misses())).as("%s", drive.misses()).isLessThan(FARTHEST_M);
    assertThat(leaps.largestM).as("leap of the state").isLessThan(LARGEST_LEAP_M);
    assertThat(drive.operator.action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(drive.contacts()).isZero();
  }

  /** In small steps, so that it is noticed where waypoints are passed. */
  private static void pass(UgvDrive drive, double seconds) throws InterruptedException {
    double end = drive.nowS() + seconds;
    drive.driveUntil("time passes", () -> drive.nowS() >= end, seconds + 1.0);
  }

  private static void swapEvery(UgvDrive drive, double seconds, String service, List<Class<?>> by)
      throws InterruptedException {
    for (Class<?> each : by) {
      pass(drive, seconds);
      drive.operator.swap(service, each);
    }
  }

  @Test
  void swap_estimatorsWhileDriving_loopIsDrivenAndTheStateDoesNotLeap() throws Exception {
    try (UgvDrive drive = start("system.xml", List.of(), "")) {
      Leaps leaps = new Leaps();
      drive.operator.onState(leaps::look);
      swapEvery(
          drive,
          11.0, // on straights and in turns
          "StateEstimator",
          List.of(
              PassThroughStateEstimator.class,
              FusingStateEstimator.class,
              ComplementaryStateEstimator.class,
              FusingStateEstimator.class,
              ComplementaryStateEstimator.class,
              PassThroughStateEstimator.class,
              ComplementaryStateEstimator.class,
              FusingStateEstimator.class));
      requireTheLoop(drive, leaps);
      assertThat(drive.operator.answers()).hasSize(8);
    }
  }

  @Tag("long")
  @Test
  void swap_plannersWhileDriving_loopIsDriven() throws Exception {
    try (UgvDrive drive = start("system.xml", List.of(), "")) {
      Leaps leaps = new Leaps();
      drive.operator.onState(leaps::look);
      swapEvery(
          drive,
          13.0,
          "PathPlanner",
          List.of(
              VectorFieldPlanner.class,
              PathPlanner.class,
              VectorFieldPlanner.class,
              PathPlanner.class));
      requireTheLoop(drive, leaps);
    }
  }

  @Test
  @Tag("long")
  void swap_modellersAmongObstacles_loopIsDrivenWithoutContact() throws Exception {
    Path file = Repository.root().resolve("missions/ugv/obstructed.xml");
    List<ObjectDescription> obstacles = WorldFile.load(file).objects();
    try (UgvDrive drive = start("system-world.xml", obstacles, file.toString())) {
      Leaps leaps = new Leaps();
      drive.operator.onState(leaps::look);
      for (String modellers :
          List.of("GRID", "OBJECTS", "GRID", "LINES, GRID", "OBJECTS, LINES, GRID")) {
        pass(drive, 12.0);
        drive.operator.set("WorldModeler", "MODELLERS", modellers);
      }
      swapEvery(drive, 9.0, "WorldModeler", List.of(WorldModeler.class, WorldModeler.class));
      swapEvery(drive, 9.0, "StateEstimator", List.of(ComplementaryStateEstimator.class));
      swapEvery(drive, 9.0, "StateEstimator", List.of(FusingStateEstimator.class));
      requireTheLoop(drive, leaps);
      assertThat(drive.operator.answers()).hasSize(9);
    }
  }
}
