package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.LidarSensor;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.Repository;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.world.WorldModeler;
import org.u2sa.world.xml.WorldFile;

/**
 * A drive round the yard of missions/ugv/yard.xml, past barrels, trees and walls: what lidar,
 * camera and World Modeler make of it, against the yard itself.
 */
class MappedYardTest {
  private static final double TICK_S = 0.2;
  private static final double SPEED_MPS = 1.5;
  private static final double LASER_M = 0.4; // above the ground
  private static final double[][] LOOP = {
    {0.0, 0.0},
    {0.0, 18.0},
    {16.0, 26.0},
    {32.0, 18.0},
    {22.0, 4.0},
    {30.0, -10.0},
    {10.0, -4.0},
    {0.0, 18.0}
  };

  private final ServiceKit kit = new ServiceKit();
  private final Geodetic home = new Geodetic(-81.0478, 29.1885, 0.0);
  private final List<ObjectDescription> yard =
      WorldFile.load(Repository.root().resolve("missions/ugv/yard.xml")).objects();
  private final World world = World.at(home).with(yard);
  private final Random noise = new Random(11L);
  private final Map<String, Integer> sightings = new TreeMap<>();
  private Point place = Point.ORIGIN; // east, north
  private double heading; // clockwise from north

  @BeforeEach
  void start() {
    SimulatedLaser.Optics optics =
        new SimulatedLaser.Optics(
            5.0, Math.toRadians(-135.0), Math.toRadians(0.5), 541, 0.06, 10.0, 0.03);
    SimulatedLaser laser =
        new SimulatedLaser(
            optics,
            new NoiseStreams(3L),
            () ->
                (angle, cos, sin) ->
                    world.distanceM(
                        Ray.of(place.plus(Point.of(0.0, 0.0, LASER_M)), heading - angle, 0.0),
                        10.0));
    kit.with("MOUNTED Z", -LASER_M).start(context -> new LidarSensor(context, laser));
    kit.withoutVariables().with("LOWEST", 0.05).with("GRID SIZE", 80.0).with("USUAL SPEED", 1.0);
    kit.with("FORGET MOVING", 5.0)
        .with("GRID RATE", 0.5)
        .with("FIELDS OF VIEW", "Camera: 120 deg, 8 m");
    kit.with("DETECTION PROBABILITY", 0.7).with("CONFIRM WINDOW", 8);
    kit.start(WorldModeler::new);
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private void drive() {
    for (int leg = 1; leg < LOOP.length; leg++) {
      double dx = LOOP[leg][0] - LOOP[leg - 1][0];
      double dy = LOOP[leg][1] - LOOP[leg - 1][1];
      double length = Math.hypot(dx, dy);
      double course = Math.atan2(dx, dy);
      while (Math.abs(Math.IEEEremainder(course - heading, 2.0 * Math.PI)) > 1e-9) {
        double turn = Math.IEEEremainder(course - heading, 2.0 * Math.PI);
        tick(place, heading + Math.max(-0.16, Math.min(0.16, turn)));
      }
      for (double way = 0.0; way < length; way += SPEED_MPS * TICK_S) {
        tick(
            Point.of(
                LOOP[leg - 1][0] + dx * way / length, LOOP[leg - 1][1] + dy * way / length, 0.0),
            course);
      }
    }
  }

  private void tick(Point next, double newHeading) {
    place = next;
    heading = newHeading;
    kit.advance(TICK_S); // at its end the laser measures
    Point global = home.fromEnu(place).point();
    kit.send(
        Channels.STATE,
        new StateInformation()
            .sensorName("StateEstimator")
            .x(global.x())
            .y(global.y())
            .z(0.0)
            .psi(heading)
            .xSigma(0.02)
            .ySigma(0.02)
            .psiSigma(0.005));
    look();
    kit.settle();
  }

  /** A camera: barrels and trees in 130°, up to 8.5 m, four of five times, with errors. */
  private void look() {
    for (ObjectDescription each : yard) {
      boolean known = each.objectType().equals("barrel") || each.objectType().equals("tree");
      Point enu = home.enuOf(Geodetic.of(each.center())).minus(place);
      double range = Math.hypot(enu.x(), enu.y());
      double bearing =
          Math.IEEEremainder(heading - Math.atan2(enu.x(), enu.y()), 2.0 * Math.PI); // left +
      if (known && range < 8.5 && Math.abs(bearing) < 1.15 && noise.nextDouble() < 0.8) {
        sightings.merge(each.uid(), 1, Integer::sum);
        double r = range + 0.1 * noise.nextGaussian();
        double b = bearing + 0.02 * noise.nextGaussian();
        ObjectDescription seen =
            new ObjectDescription()
                .uid("seen")
                .objectType(each.objectType())
                .sensorName("Camera")
                .referenceFrame(ReferenceFrame.BODY)
                .x(r * Math.cos(b))
                .y(r * Math.sin(b));
        seen.motion().sigma(Point.of(0.15, 0.15, 0.15));
        kit.send(Channels.SENSED_OBJECTS, seen);
      }
    }
  }

  @Test
  void drive_roundTheYard_gridAndObjectsAreTheYard() throws IOException {
    drive();
    OccupancyGrid grid = kit.latest(Channels.GRID).orElseThrow();
    List<ObjectDescription> objects = kit.latest(Channels.OBJECTS).orElseThrow().objects();
    draw(grid, objects, Path.of("target/mapped-yard.png"));
    int occupied = 0;
    int far = 0;
    byte[] cells = grid.cells();
    for (int i = 0; i < cells.length; i++) {
      if (cells[i] > 0) {
        occupied++;
        far += toYard(grid.centerOf(i % grid.columns(), i / grid.columns())) > 0.2 ? 1 : 0;
      }
    }
    assertThat(occupied).isGreaterThan(200);
    assertThat(far / (double) occupied).isLessThan(0.02);
    for (ObjectDescription each : yard) {
      if (!each.objectType().equals("building")) {
        assertThat(occupiedNear(grid, each)).as(each.uid()).isTrue();
      }
      assertThat(OccupancyGrid.probability(grid.cellAt(each.center())))
          .as("inside of " + each.uid())
          .isGreaterThanOrEqualTo(0.5);
    }
    for (ObjectDescription object : objects) {
      assertThat(nearest(object, yard)).as(object.toString()).isLessThan(0.35);
    }
    assertThat(objects).hasSizeLessThanOrEqualTo(sightings.size());
    for (ObjectDescription each : yard) {
      if (sightings.getOrDefault(each.uid(), 0) >= 10) {
        assertThat(nearest(each, objects)).as(each.uid()).isLessThan(0.35);
      }
    }
    assertThat(objects).hasSizeGreaterThanOrEqualTo(7);
  }

  private double toYard(Point at) {
    double nearest = Double.POSITIVE_INFINITY;
    for (ObjectDescription each : yard) {
      nearest = Math.min(nearest, each.distanceTo(Point.of(at.x(), at.y(), each.z())));
    }
    return nearest;
  }

  private boolean occupiedNear(OccupancyGrid grid, ObjectDescription object) {
    byte[] cells = grid.cells();
    for (int i = 0; i < cells.length; i++) {
      if (cells[i] > 0) {
        Point at = grid.centerOf(i % grid.columns(), i / grid.columns());
        if (object.distanceTo(Point.of(at.x(), at.y(), object.z())) < 0.2) {
          return true;
        }
      }
    }
    return false;
  }

  private double nearest(ObjectDescription seen, List<ObjectDescription> others) {
    Point at = home.enuOf(Geodetic.of(seen.center()));
    double nearest = Double.POSITIVE_INFINITY;
    for (ObjectDescription each : others) {
      if (each.objectType().equals(seen.objectType())) {
        Point off = home.enuOf(Geodetic.of(each.center())).minus(at);
        nearest = Math.min(nearest, Math.hypot(off.x(), off.y()));
      }
    }
    return nearest;
  }

  /** For whoever wants to look at it; nothing depends on it. */
  private void draw(OccupancyGrid grid, List<ObjectDescription> objects, Path file)
      throws IOException {
    BufferedImage image =
        new BufferedImage(grid.columns(), grid.rows(), BufferedImage.TYPE_INT_RGB);
    byte[] cells = grid.cells();
    for (int i = 0; i < cells.length; i++) {
      int grey = (int) Math.round(255.0 * (1.0 - OccupancyGrid.probability(cells[i])));
      set(image, i % grid.columns(), i / grid.columns(), grey * 0x10101);
    }
    List<ObjectDescription> all = new ArrayList<>(objects);
    for (ObjectDescription object : all) {
      Point metres =
          new Geodetic(grid.anchor().x(), grid.anchor().y(), 0.0)
              .enuOf(Geodetic.of(object.center()));
      int column = (int) ((metres.x() - grid.left()) / grid.resolution());
      int row = (int) ((metres.y() - grid.bottom()) / grid.resolution());
      for (int k = -8; k <= 8; k++) {
        set(image, column + k, row, 0xD00000);
        set(image, column, row + k, 0xD00000);
      }
    }
    Files.createDirectories(file.getParent());
    ImageIO.write(image, "png", file.toFile());
  }

  private static void set(BufferedImage image, int column, int row, int colour) {
    if (column >= 0 && row >= 0 && column < image.getWidth() && row < image.getHeight()) {
      image.setRGB(column, image.getHeight() - 1 - row, colour);
    }
  }
}
