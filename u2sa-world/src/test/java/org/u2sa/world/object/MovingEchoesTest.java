package org.u2sa.world.object;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.world.ModelledWorld.local;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.world.ModelledWorld;
import org.u2sa.world.WorldModeler;

/** What moves is told from what stands by a laser's echoes alone. */
class MovingEchoesTest {
  private static final int BEAMS = 541;
  private static final double STEP_RAD = Math.toRadians(0.5);
  private static final double REACH_M = 10.0;
  private static final double SIGMA_M = 0.03;

  /** A pillar, or a person: north, east, radius [m]. */
  private record Disc(double north, double east, double radius) {}

  private final ModelledWorld world = new ModelledWorld();
  private final Random noise = new Random(28L);
  private final List<Disc> stand = new ArrayList<>();
  private final Set<String> moved = new HashSet<>();

  @AfterEach
  void close() {
    world.close();
  }

  private static double rangeM(Disc disc, double north, double east, double azimuth) {
    double dn = disc.north - north;
    double de = disc.east - east;
    double along = dn * Math.cos(azimuth) + de * Math.sin(azimuth);
    double beside = de * Math.cos(azimuth) - dn * Math.sin(azimuth);
    double half = disc.radius * disc.radius - beside * beside;
    return along > 0.0 && half > 0.0 ? along - Math.sqrt(half) : Double.POSITIVE_INFINITY;
  }

  /** A tenth of a second: a scan from there of all that stands and of who walks. */
  private void look(double north, double east, double psi, List<Disc> walk) {
    List<Disc> all = new ArrayList<>(stand);
    all.addAll(walk);
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < BEAMS; i++) {
      double azimuth = psi - (-0.5 * (BEAMS - 1) + i) * STEP_RAD; // beams go round to the left
      double seen = Double.POSITIVE_INFINITY;
      for (Disc disc : all) {
        seen = Math.min(seen, rangeM(disc, north, east, azimuth));
      }
      double measured = seen + SIGMA_M * noise.nextGaussian();
      ranges.add(measured <= REACH_M ? OptionalDouble.of(measured) : OptionalDouble.empty());
    }
    world.kit.send(Channels.STATE, local(north, east, psi));
    world.kit.send(
        Channels.SCANS,
        new RangeScan()
            .sensorName("Laser")
            .z(-0.4)
            .minRange(0.06)
            .maxRange(REACH_M)
            .beams(-0.5 * (BEAMS - 1) * STEP_RAD, STEP_RAD, ranges));
    world.kit.settle();
    world.kit.advance(0.1);
    for (ObjectDescription object : world.objects()) {
      if (object instanceof MovingSphere) {
        moved.add(object.uid());
      }
    }
  }

  private void start() {
    world.kit.with("MODELLERS", "OBJECTS, GRID").with("LOWEST", 0.05).start(WorldModeler::new);
  }

  private void crossing(int scans) {
    for (int i = 0; i < scans; i++) {
      look(0.05 * i, 0.0, 0.0, List.of(new Disc(6.0, -4.0 + 0.1 * i, 0.3)));
    }
  }

  @Test
  void scan_walkerAmongPillars_isPublishedWithHisVelocityAndNothingElse() {
    start();
    stand.addAll(List.of(new Disc(8.0, -2.0, 0.3), new Disc(4.0, 1.5, 0.2)));
    crossing(25);

    assertThat(world.objects()).hasSize(1);
    MovingSphere walker = (MovingSphere) world.objects().get(0);
    assertThat(walker.motion().velocity().orElseThrow().distanceTo(Point.of(0.0, 1.0, 0.0)))
        .isLessThan(0.3);
    assertThat(walker.center().distanceTo(Point.of(6.0, -1.5, -0.4))).isLessThan(0.3);
    assertThat(walker.radius()).isBetween(1.15, 1.5); // his own 0.3 m and BUFFER
  }

  @Test
  void scan_walkerComesOnSlowly_isKnownToMoveWithinAFewSteps() {
    start();
    for (int i = 0; i < 40; i++) {
      look(0.0, 0.0, 0.0, List.of(new Disc(6.0 - 0.03 * i, 0.0, 0.3)));
    }

    assertThat(world.objects()).hasSize(1);
    assertThat(world.objects().get(0).motion().velocity().orElseThrow().x()).isLessThan(-0.2);
  }

  @Test
  void scan_walkerWalksOn_isGoneWhereTheScannerSeesThatNobodyIs() {
    start();
    crossing(25);
    assertThat(world.objects()).hasSize(1);
    for (int i = 0; i < 12; i++) {
      look(1.25, 0.0, 0.0, List.of());
    }
    assertThat(world.objects()).isEmpty();
  }

  /** Pillars come into reach, and out from behind each other, all the while. */
  @Test
  void scan_vehicleDrivesAndTurnsAmongPillars_nothingMoves() {
    start();
    Random places = new Random(7L);
    for (int i = 0; i < 60; i++) {
      stand.add(
          new Disc(
              20.0 * places.nextDouble() - 2.0,
              (places.nextBoolean() ? 1.0 : -1.0) * (1.0 + 7.0 * places.nextDouble()),
              0.05 + 0.3 * places.nextDouble()));
    }
    for (int i = 0; i < 150; i++) {
      look(0.1 * i, 0.3 * Math.sin(0.1 * i), 0.6 * Math.sin(0.07 * i), List.of());
    }

    assertThat(moved).isEmpty();
    assertThat(world.objects()).isEmpty();
  }

  @Test
  void scan_moversInScansIsFalse_nothingIsPublished() {
    world.kit.with("MOVERS IN SCANS", false);
    start();
    crossing(25);

    assertThat(world.objects()).isEmpty();
  }

  /** Without a state nobody knows whether the walker moves or the vehicle. */
  @Test
  void scan_noState_nothingIsPublished() {
    start();
    for (int i = 0; i < 25; i++) {
      world.kit.send(Channels.SCANS, ModelledWorld.wallAhead(8.0 - 0.1 * i));
      world.kit.settle();
      world.kit.advance(0.1);
    }

    assertThat(world.objects()).isEmpty();
  }
}
