package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.LidarSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.RangeScan;
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
  private Consumer<Boolean> mute;

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
    service = kit.start(context -> new LidarSensor(context, new Rplidar(link)));
    return device;
  }

  private SimulatedHokuyo hokuyo() {
    SimulatedHokuyo device = new SimulatedHokuyo(link, kit.clock()::micros, LidarSensorTest::wall);
    kit.with("PUBLISH EVERY", 4);
    service = kit.start(context -> new LidarSensor(context, new Hokuyo(link)));
    return device;
  }

  private List<RangeScan> scans() {
    return kit.published(Channels.SCANS);
  }

  private String lastError() {
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse("");
  }

  /** Checks a scan for its number of beams and the number of echoes from the wall. */
  private void assertWallAhead(int beams, int echoes) {
    assertThat(scans()).isNotEmpty();
    RangeScan scan = scans().get(scans().size() - 1);
    assertThat(scan.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(scan.sensorName()).isEqualTo("LidarSensor");
    assertThat(scan.beams()).as("those without an echo too").hasSize(beams);
    assertThat(scan.points()).hasSize(echoes);
    for (Point point : scan.points()) {
      assertThat(point.x()).isCloseTo(WALL_M + 0.2, within(0.01));
      assertThat(point.z()).isCloseTo(-0.5, within(1.0e-9));
    }
    assertThat(scan.points().stream().mapToDouble(Point::y).max().orElseThrow())
        .isCloseTo(WALL_M * Math.tan(Math.toRadians(60.0)), within(0.02));
  }

  @Test
  void rplidar_scans_areInBody() {
    rplidar();
    kit.advance(1.0);
    assertWallAhead(360, 121);
    assertThat(scans()).hasSizeBetween(7, 10);
  }

  @Test
  void hokuyo_scans_areInBody() {
    hokuyo();
    kit.advance(1.0);
    assertWallAhead(1081, 481);
    assertThat(scans()).as("each fourth of 40 a second").hasSizeBetween(8, 10);
  }

  @Test
  void rplidar_scan_hasTheTimeOfItsFirstBeam() {
    rplidar();
    kit.advance(1.0);
    List<RangeScan> all = scans();
    RangeScan last = all.get(all.size() - 1);
    RangeScan before = all.get(all.size() - 2);
    assertThat(last.timestamp().getAsLong() - before.timestamp().getAsLong())
        .as("ten turns a second")
        .isCloseTo(100_000L, within(20_000L));
    assertThat(last.timeIncrement()).isCloseTo(0.1 / 360, within(0.02 / 360));
    assertThat(last.timestamp().getAsLong() + Clock.micros(0.1))
        .as("it ended before it was published")
        .isLessThanOrEqualTo(kit.clock().micros());
  }

  @Test
  void hokuyo_scan_hasTheTimeOfItsFirstBeam() {
    hokuyo();
    kit.advance(1.0);
    RangeScan last = scans().get(scans().size() - 1);
    assertThat(last.timeIncrement()).as("40 turns of 1440 steps").isEqualTo(0.025 / 1440);
    assertThat(kit.clock().micros() - last.timestamp().getAsLong())
        .isBetween(Clock.micros(0.025 * 1080 / 1440), Clock.micros(0.15));
    assertThat(last.startAngle()).isCloseTo(Math.toRadians(-135.0), within(1.0e-9));
    assertThat(last.angleIncrement()).isCloseTo(Math.toRadians(0.25), within(1.0e-9));
    assertThat(last.minRange()).as("NEAREST").isEqualTo(0.1);
    assertThat(last.maxRange()).as("its own").isEqualTo(30.0);
  }

  @Test
  void bothFamilies_nothingInReach_areScansWithoutEcho() {
    SimulatedRplidar device = new SimulatedRplidar(link, kit.clock()::micros, degrees -> 0.0);
    service = kit.start(context -> new LidarSensor(context, new Rplidar(link)));
    kit.advance(1.0);
    assertThat(device.isScanning()).isTrue();
    assertThat(scans()).hasSizeBetween(7, 10);
    assertThat(scans())
        .allSatisfy(scan -> assertThat(scan.returns()).hasSize(360).doesNotContain(true));
    kit.forget();
    MemoryLink other = new MemoryLink();
    new SimulatedHokuyo(other, kit.clock()::micros, degrees -> 0.0);
    kit.with("SERVICE NAME", "other");
    kit.start(context -> new LidarSensor(context, new Hokuyo(other)));
    kit.advance(0.5);
    assertThat(scans().stream().filter(scan -> scan.sensorName().equals("other")))
        .isNotEmpty()
        .allSatisfy(scan -> assertThat(scan.returns()).hasSize(1081).doesNotContain(true));
  }

  @Test
  void hokuyo_thatWakesUpWithScip1_isToldToSpeakScip2AtEachStart() {
    SimulatedHokuyo device = new SimulatedHokuyo(link, kit.clock()::micros, LidarSensorTest::wall);
    device.powerOn(true);
    service = kit.start(context -> new LidarSensor(context, new Hokuyo(link)));
    kit.advance(1.0);
    assertWallAhead(1081, 481);
    device.powerOn(true); // power went and came, the line stayed
    kit.forget();
    kit.advance(2.0);
    assertThat(device.isScip1()).isFalse();
    assertWallAhead(1081, 481);
    link.unplug();
    kit.advance(1.0);
    device.powerOn(true);
    kit.forget();
    link.plug();
    kit.advance(2.0);
    assertWallAhead(1081, 481);
  }

  @Test
  void hokuyo_inScip2Already_itsRefusalWillDo() {
    SimulatedHokuyo device = new SimulatedHokuyo(link, kit.clock()::micros, LidarSensorTest::wall);
    device.powerOn(true);
    link.write("SCIP2.0\n".getBytes(US_ASCII)); // by another program, before
    assertThat(device.isScip1()).isFalse();
    service = kit.start(context -> new LidarSensor(context, new Hokuyo(link)));
    kit.advance(1.0);
    assertWallAhead(1081, 481);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError)).isEmpty();
  }

  @Test
  void rplidar_onItsMotorBoard_motorIsRunAndStoppedAtTheEnd() {
    SimulatedRplidar device =
        new SimulatedRplidar(link, kit.clock()::micros, LidarSensorTest::wall);
    device.withMotorBoard();
    service = kit.start(context -> new LidarSensor(context, new Rplidar(link)));
    kit.advance(1.5);
    assertThat(device.motorRequests()).containsExactly("a5f0029402c1");
    assertWallAhead(360, 121);
    service.kill();
    assertThat(device.motorRequests()).containsExactly("a5f0029402c1", "a5f002000057");
    assertThat(device.isScanning()).isFalse();
  }

  @Test
  void rplidar_a1_isNotToldOfAMotor() {
    SimulatedRplidar device = rplidar();
    kit.advance(1.0);
    service.kill();
    assertThat(device.motorRequests()).isEmpty();
  }

  @Test
  void rplidar_turnedAround_seesTheWallBehind() {
    kit.with("MOUNTED YAW", Math.PI);
    rplidar();
    kit.advance(1.0);
    assertThat(scans().get(0).points())
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
    assertWallAhead(360, 121);
  }

  @Test
  void hokuyo_broken_isSaidAndGoesOnWhenItIsWell() {
    SimulatedHokuyo device = hokuyo();
    kit.advance(0.5);
    device.broken(true);
    kit.advance(3.0);
    assertThat(kit.log("LidarSensor"))
        .anySatisfy(
            line -> assertThat(line).contains("the laser answered MD0000108001000 with status 50"));
    device.broken(false);
    kit.advance(1.8);
    kit.forget();
    kit.advance(0.2);
    assertWallAhead(1081, 481);
  }

  @Test
  void rplidar_bytesLost_noPointIsWrongAndItGoesOnWithinTwoSeconds() {
    SimulatedRplidar device = rplidar();
    kit.advance(1.0);
    device.dropEach(997);
    kit.advance(3.0);
    assertThat(lastError()).contains("the laser sent invalid data");
    device.dropEach(0);
    kit.advance(1.8);
    assertThat(scans())
        .allSatisfy(
            scan ->
                assertThat(scan.points())
                    .allSatisfy(
                        point -> assertThat(point.x()).isCloseTo(WALL_M + 0.2, within(0.01))));
    kit.forget();
    kit.advance(0.2);
    assertWallAhead(360, 121);
  }

  @Test
  void hokuyo_wrongSums_noScanAndItGoesOnWithinTwoSeconds() {
    SimulatedHokuyo device = hokuyo();
    kit.advance(1.0);
    device.wrongSums(true);
    kit.advance(0.1);
    kit.forget();
    kit.advance(3.0);
    assertThat(scans()).isEmpty();
    assertThat(lastError()).contains("the laser");
    device.wrongSums(false);
    kit.advance(2.0);
    assertWallAhead(1081, 481);
  }

  /** Starts either laser; returns what it looks like when it works. */
  private Runnable laser(boolean isHokuyo) {
    if (isHokuyo) {
      SimulatedHokuyo device = hokuyo();
      mute = device::mute;
      return () -> assertWallAhead(1081, 481);
    }
    SimulatedRplidar device = rplidar();
    mute = device::mute;
    return () -> assertWallAhead(360, 121);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void step_unplugged_isSetUpAgainWithinTwoSeconds(boolean isHokuyo) {
    Runnable works = laser(isHokuyo);
    kit.advance(1.0);
    link.unplug();
    kit.advance(5.0);
    assertThat(lastError()).isEqualTo("the laser is lost: unplugged");
    kit.forget();
    link.plug();
    kit.advance(2.0);
    works.run();
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void step_mute_isSaidAndGoesOnWithinTwoSeconds(boolean isHokuyo) {
    Runnable works = laser(isHokuyo);
    kit.advance(1.0);
    mute.accept(true);
    kit.advance(5.0);
    assertThat(lastError()).contains("the laser");
    mute.accept(false);
    kit.forget();
    kit.advance(2.0);
    works.run();
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
}
