package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Mission;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.testkit.Repository;

/**
 * The loop with the shipped files, in which one walker after the other comes, of whom only the
 * laser tells: one on each leg, head-on or across, at 0.3 to 1.5 m/s.
 */
class LaserAloneTest {
  private static final double[] SPEEDS_MPS = {0.3, 1.0, 1.5};
  private static final double ROVER_MPS = 0.95;
  private static final double TURNS_S = 2.0; // and sets off
  private static final double ENOUGH_S = 600.0;

  @TempDir private Path directory;

  /** Along a leg and to the right of it: east, north [m]. */
  private static Point beside(Point from, Point to, double along, double right) {
    Point way = to.minus(from);
    double length = Math.hypot(way.x(), way.y());
    double east = way.x() / length;
    double north = way.y() / length;
    return Point.of(
        from.x() + along * east + right * north, from.y() + along * north - right * east, 0.0);
  }

  private static Walkers.Walker walker(Point from, Point to, int leg, double nowS, Random chance) {
    double mps = SPEEDS_MPS[leg % SPEEDS_MPS.length];
    double metS = TURNS_S + 0.5 * from.distanceTo(to) / ROVER_MPS + 1.5 * chance.nextGaussian();
    double along = 0.5 * from.distanceTo(to);
    double aside = 0.3 * chance.nextGaussian();
    boolean isHeadOn = chance.nextBoolean();
    double side = chance.nextBoolean() ? 1.0 : -1.0;
    Point met = beside(from, to, along, isHeadOn ? aside : 0.0);
    Point start =
        isHeadOn
            ? beside(from, to, along + mps * metS, aside)
            : beside(from, to, along, side * mps * metS);
    return new Walkers.Walker(start, met, mps, nowS);
  }

  private Walkers meet(long seed, int legs) throws InterruptedException {
    Path system = UgvDrive.config().resolve("system-world.xml");
    try (UgvDrive drive =
        new UgvDrive(
            directory,
            system,
            new UgvDrive.Scene(seed, GpsGrade.SURVEY, Hazards.none(), List.of()),
            true,
            options -> {})) {
      Mission mission = Mission.load(Repository.root().resolve("missions/ugv/loop.xml"));
      Random chance = new Random(seed);
      Point from = Point.ORIGIN;
      Geodetic origin = drive.vehicle.world().plane().at(0.0, 0.0, 0.0);
      for (int leg = 0; leg < legs; leg++) {
        Waypoint next = (Waypoint) mission.goals().get(leg);
        Point to = origin.enuOf(new Geodetic(next.x().getAsDouble(), next.y().getAsDouble(), 0.0));
        drive.walkers.add(walker(from, to, leg, drive.nowS(), chance));
        int done = leg + 1;
        drive.driveUntil("leg " + done, () -> drive.operator.goalsDone() >= done, ENOUGH_S);
        from = to;
      }
      assertThat(drive.contacts()).isZero();
      return drive.walkers;
    }
  }

  @Test
  void drive_walkersOnTwoLegs_drivesIntoNobody() throws Exception {
    assertThat(meet(1, 2).drivenInto()).isEmpty();
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void drive_walkersOnEachLeg_drivesIntoNobodyAndCompletesTheLoop(long seed) throws Exception {
    assertThat(meet(seed, 6).drivenInto()).isEmpty();
  }
}
