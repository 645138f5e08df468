package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.PointCloud;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** Both laser families before a wall 3 m ahead of the laser, simulated byte for byte. */
class LidarSensorTest {
  private static final double WALL_M = 3.0;

  private final ServiceKit kit = new ServiceKit().with("MOUNTED X", 0.2).with("MOUNTED Z", -0.5);
  private final MemoryLink link = new MemoryLink();
  private LidarSensor service;

  @AfterEach
  void end() {
    kit.close();
  }

  /** Distance to the wall in a direction [deg], 0 where there is none within 60 degrees. */
  private static double wall(double degrees) {
    double off = Math.abs(degrees > 180.0 ? degrees - 360.0 : degrees);
    return off <= 60.0 ? WALL_M / Math.cos(Math.toRadians(off)) : 0.0;
  }

  private SimulatedRplidar rplidar() {
    SimulatedRplidar device =
        new SimulatedRplidar(link, kit.clock()::micros, LidarSensorTest::wall);
    service = kit.start(context -> new LidarSensor(context, link));
    return device;
  }

  private SimulatedHokuyo hokuyo() {
    SimulatedHokuyo device = new SimulatedHokuyo(link, kit.clock()::micros, LidarSensorTest::wall);
    kit.with("LIDAR", "hokuyo").with("PUBLISH EVERY", 4);
    service = kit.start(context -> new LidarSensor(context, link));
    return device;
  }

  private List<ObjectDescription> clouds() {
    return kit.published(Channels.SENSED_OBJECTS);
  }

  private String lastError() {
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse("");
  }

  private void assertWallAhead(int points) {
    assertThat(clouds()).isNotEmpty();
    PointCloud cloud = (PointCloud) clouds().get(clouds().size() - 1);
    assertThat(cloud.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(cloud.uid()).isEqualTo("LidarSensor");
    assertThat(cloud.points()).hasSize(points);
    for (Point point : cloud.points()) {
      assertThat(point.x()).isCloseTo(WALL_M + 0.2, within(0.01));
      assertThat(point.z()).isCloseTo(-0.5, within(1.0e-9));
    }
    assertThat(cloud.points().stream().mapToDouble(Point::y).max().orElseThrow())
        .isCloseTo(WALL_M * Math.tan(Math.toRadians(60.0)), within(0.02));
    assertThat(cloud.center().distanceTo(Point.of(WALL_M + 0.2, 0.0, -0.5))).isLessThan(0.05);
  }

  @Test
  void rplidar_scans_areCloudsInBody() {
    rplidar();
    kit.advance(1.0);
    assertWallAhead(121);
    assertThat(clouds()).hasSizeBetween(7, 10);
  }

  @Test
  void hokuyo_scans_areCloudsInBody() {
    hokuyo();
    kit.advance(1.0);
    assertWallAhead(481);
    assertThat(clouds()).as("each fourth of 40 a second").hasSizeBetween(8, 10);
  }

  @Test
  void rplidar_turnedAround_seesTheWallBehind() {
    kit.with("MOUNTED YAW", Math.PI);
    rplidar();
    kit.advance(1.0);
    PointCloud cloud = (PointCloud) clouds().get(0);
    assertThat(cloud.points())
        .allSatisfy(point -> assertThat(point.x()).isCloseTo(-WALL_M + 0.2, within(0.01)));
  }

  @Test
  void rplidar_stoppedToProtectItself_isSaidAndReset() {
    SimulatedRplidar device = rplidar();
    kit.advance(1.0);
    device.status(2);
    kit.advance(1.5);
    assertThat(kit.log("LidarSensor"))
        .anySatisfy(line -> assertThat(line).contains("protect itself, error 0x8003"));
    kit.advance(2.0);
    kit.forget();
    kit.advance(0.5);
    assertThat(device.resets()).isEqualTo(1);
    assertWallAhead(121);
  }

  @Test
  void hokuyo_broken_isSaidAndGoesOnWhenItIsWell() {
    SimulatedHokuyo device = hokuyo();
    kit.advance(0.5);
    device.broken(true);
    kit.advance(3.0);
    assertThat(kit.log("LidarSensor"))
        .anySatisfy(line -> assertThat(line).contains("status 50 in answer to MD0000108001000"));
    device.broken(false);
    kit.advance(1.8);
    kit.forget();
    kit.advance(0.2);
    assertWallAhead(481);
  }

  @Test
  void rplidar_bytesLost_noPointIsWrongAndItGoesOnWithinTwoSeconds() {
    SimulatedRplidar device = rplidar();
    kit.advance(1.0);
    device.dropEach(997);
    kit.advance(3.0);
    assertThat(lastError()).contains("the laser sent what cannot be read");
    device.dropEach(0);
    kit.advance(1.8);
    assertThat(clouds())
        .allSatisfy(
            cloud ->
                assertThat(((PointCloud) cloud).points())
                    .allSatisfy(
                        point -> assertThat(point.x()).isCloseTo(WALL_M + 0.2, within(0.01))));
    kit.forget();
    kit.advance(0.2);
    assertWallAhead(121);
  }

  @Test
  void hokuyo_wrongSums_noCloudAndItGoesOnWithinTwoSeconds() {
    SimulatedHokuyo device = hokuyo();
    kit.advance(1.0);
    device.wrongSums(true);
    kit.advance(0.1);
    kit.forget();
    kit.advance(3.0);
    assertThat(clouds()).isEmpty();
    assertThat(lastError()).contains("the laser");
    device.wrongSums(false);
    kit.advance(2.0);
    assertWallAhead(481);
  }

  private void unplugFor(double seconds) {
    kit.advance(1.0);
    link.unplug();
    kit.advance(seconds);
    assertThat(lastError()).isEqualTo("the laser is lost: unplugged");
    kit.forget();
    link.plug();
    kit.advance(2.0);
  }

  @Test
  void rplidar_unplugged_isSetUpAgainWithinTwoSeconds() {
    rplidar();
    unplugFor(5.0);
    assertWallAhead(121);
  }

  @Test
  void hokuyo_unplugged_isSetUpAgainWithinTwoSeconds() {
    hokuyo();
    unplugFor(5.0);
    assertWallAhead(481);
  }

  @Test
  void rplidar_mute_isSaidAndGoesOnWithinTwoSeconds() {
    SimulatedRplidar device = rplidar();
    kit.advance(1.0);
    device.mute(true);
    kit.advance(5.0);
    assertThat(lastError()).contains("the laser");
    device.mute(false);
    kit.forget();
    kit.advance(2.0);
    assertWallAhead(121);
  }

  @Test
  void hokuyo_mute_isSaidAndGoesOnWithinTwoSeconds() {
    SimulatedHokuyo device = hokuyo();
    kit.advance(1.0);
    device.mute(true);
    kit.advance(5.0);
    assertThat(lastError()).contains("the laser");
    device.mute(false);
    kit.forget();
    kit.advance(2.0);
    assertWallAhead(481);
  }

  @Test
  void kill_scanning_stopsTheDevice() {
    SimulatedRplidar device = rplidar();
    kit.advance(1.0);
    service.kill();
    assertThat(device.isScanning()).isFalse();
    assertThat(link.isClosed()).isTrue();
  }

  @Test
  void kill_measuring_switchesTheLaserOff() {
    SimulatedHokuyo device = hokuyo();
    kit.advance(1.0);
    assertThat(device.isLit()).isTrue();
    service.kill();
    assertThat(device.isLit()).isFalse();
  }

  @Test
  void step_randomBytes_noExceptionForEitherFamily() {
    for (String family : List.of("rplidar", "hokuyo")) {
      MemoryLink noisy = new MemoryLink();
      kit.with("LIDAR", family).with("SERVICE NAME", family);
      kit.start(context -> new LidarSensor(context, noisy));
      Random random = new Random(6);
      for (int i = 0; i < 200; i++) {
        byte[] noise = new byte[random.nextInt(600)];
        random.nextBytes(noise);
        noisy.fromDevice(noise);
        kit.advance(0.01);
      }
    }
    kit.advance(0.3);
    assertThat(kit.published(Channels.HEALTH))
        .allSatisfy(health -> assertThat(health.exceptions()).isZero());
    assertThat(clouds()).isEmpty();
  }
}
