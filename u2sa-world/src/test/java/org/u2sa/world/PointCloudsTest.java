package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.world.ModelledWorld.local;
import static org.u2sa.world.ModelledWorld.seen;
import static org.u2sa.world.ModelledWorld.wallAhead;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.PointCloud;

/** What a scanner sees that publishes clouds of points. */
class PointCloudsTest {
  private final ModelledWorld world = new ModelledWorld();

  @AfterEach
  void close() {
    world.close();
  }

  private static PointCloud cloud(String sensor, Point... points) {
    Point nearest = points.length == 0 ? Point.ORIGIN : points[0];
    PointCloud cloud = new PointCloud().points(List.of(points)).uid(sensor);
    cloud.referenceFrame(ReferenceFrame.BODY).x(nearest.x()).y(nearest.y()).sensorName(sensor);
    return cloud;
  }

  /** What a vehicle at x, facing north, sees of a wall 2 m to its left, from x = 0 to 30 m. */
  private static PointCloud wallBeside(double x) {
    List<Point> points = new ArrayList<>();
    for (double ahead = 0.0; ahead <= 10.0; ahead += 0.5) {
      points.add(Point.of(ahead, 2.0, 0.0));
      points.add(Point.of(-Math.min(ahead, x), 2.0, 0.0));
    }
    return cloud("Points", points.toArray(new Point[0]));
  }

  private List<String> awaited() {
    return world.kit.latest(Channels.OBJECTS).orElseThrow().awaited();
  }

  @Test
  void objects_driveAlongAWall_wallStaysACloudWhereItIs() {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 60; i++) {
      world.tick(local(0.1 * i, 0.0, 0.0), wallBeside(0.1 * i));

      for (ObjectDescription object : world.objects()) {
        assertThat(object).isInstanceOf(PointCloud.class);
        assertThat(((PointCloud) object).points())
            .allMatch(point -> Math.abs(point.y() + 2) < 0.01);
      }
    }
    assertThat(world.objects()).hasSize(1);
    assertThat(world.objects().get(0).distanceTo(Point.of(12.0, -2.0, 0.0))).isLessThan(0.3);
  }

  /** Readers accept lists of 1 MiB: a longer one would not arrive at all. */
  @ParameterizedTest
  @CsvSource({"50, 0.01", "0.1, 0"}) // far away, and close above the vehicle
  void objects_morePointsThanAListTakes_othersStayWhole(double nearM, double stepM) {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    ObjectDescription[] clouds = new ObjectDescription[6];
    for (int sensor = 0; sensor < 5; sensor++) {
      List<Point> far = new ArrayList<>();
      for (int i = 0; i < 9_950; i++) {
        far.add(Point.of(nearM + stepM * i, 0.0, -3.0));
      }
      clouds[sensor] = cloud("Far " + sensor, far.toArray(new Point[0]));
    }
    clouds[5] = wallBeside(0.0);
    world.tick(local(0.0, 0.0, 0.0), clouds);

    ObjectList list = world.kit.latest(Channels.OBJECTS).orElseThrow();
    assertThat(list.serialize().length).isLessThan(1 << 20);
    PointCloud wall =
        list.objects().stream()
            .filter(object -> object.sensorName().equals("Points"))
            .map(PointCloud.class::cast)
            .findAny()
            .orElseThrow();
    assertThat(wall.points()).hasSize(wallBeside(0.0).points().size());
    for (ObjectDescription object : list.objects()) {
      assertThat(object.distanceTo(Point.ORIGIN)).as("its nearest point").isLessThan(51.0);
    }
    world.stand(20);
    assertThat(world.remarks()).contains("points left out");
  }

  @Test
  void objects_nothingIsSeenAnyMore_cloudIsGoneAndOtherObjectsStay() {
    world.kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0), wallBeside(0.0), seen("a", 5.0, 0.0));
    world.tick(local(0.0, 0.0, 0.0));
    assertThat(world.objects()).hasSize(2);

    world.tick(local(0.0, 0.0, 0.0), cloud("Points"));
    world.tick(local(0.0, 0.0, 0.0));
    assertThat(world.objects()).singleElement().isInstanceOf(Circle.class);
  }

  @Test
  void reactive_emptyCloud_isNotPublished() {
    world.kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0), wallBeside(0.0));
    world.tick(local(0.0, 0.0, 0.0));
    assertThat(world.objects()).hasSize(1);

    world.tick(local(0.0, 0.0, 0.0), cloud("Points"));
    world.tick(local(0.0, 0.0, 0.0));
    assertThat(world.objects()).isEmpty();
  }

  @Test
  void objects_cloudOfOneObjectAmongOthers_isFollowedAsAnObject() {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      PointCloud bush = cloud("Camera", Point.of(4.0, 1.0, 0.0), Point.of(4.2, 1.0, 0.0));
      world.tick(local(0.0, 0.0, 0.0), bush.uid("bush"));
    }
    world.stand(20);

    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("bush");
    assertThat(awaited()).isEmpty();
  }

  @Test
  void modellers_reactiveBecomesObjects_echoesOfALaserAreNoObjectForEver() {
    world.kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    world.kit.send(Channels.SCANS, wallAhead(4.0));
    world.stand(2);
    assertThat(world.objects()).hasSize(1);
    world.change("MODELLERS", "OBJECTS");
    world.stand(5);

    assertThat(world.objects()).isEmpty();
  }

  @Test
  void scannerOfClouds_fallsSilent_isAwaited() {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.tick(local(0.0, 0.0, 0.0), wallBeside(0.0));
    }
    world.stand(8);
    assertThat(awaited()).isEmpty();
    world.stand(5);
    assertThat(awaited()).containsExactly("Points");
  }

  @Test
  void scannerOfClouds_expectedOnAnEmptyField_isNotAwaited() {
    world.kit.with("MODELLERS", "OBJECTS").with("EXPECTED SENSORS", "Points");
    world.kit.start(WorldModeler::new);
    world.stand(20);
    assertThat(awaited()).containsExactly("Points");
    for (int i = 0; i < 20; i++) {
      world.tick(local(0.0, 0.0, 0.0), cloud("Points"));
    }
    assertThat(awaited()).isEmpty();
  }

  @Test
  void scannerOfClouds_withGrid_aScannerForTheGridIsStillAwaited() {
    world.kit.with("MODELLERS", "OBJECTS, GRID").start(WorldModeler::new);
    for (int i = 0; i < 20; i++) {
      world.tick(local(0.0, 0.0, 0.0), cloud("Points"));
    }
    assertThat(awaited()).containsExactly("any scanner");
  }

  @Test
  void scannerOfClouds_silentDuringASwap_isAwaitedAfterIt() {
    world.kit.with("MODELLERS", "OBJECTS");
    WorldModeler first = world.kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.tick(local(0.0, 0.0, 0.0), wallBeside(0.0));
    }
    world.kit.swap(first, WorldModeler::new);
    world.stand(15);

    assertThat(awaited()).containsExactly("Points");
  }
}
