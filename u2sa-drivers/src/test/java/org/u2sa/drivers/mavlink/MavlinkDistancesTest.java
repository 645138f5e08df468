package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.messages.RangeScan;

/** Range finders and scanners by MAVLink; the frames were packed by pymavlink 2.4.41. */
class MavlinkDistancesTest {
  /** A radar, id 7: 12.34 m of 0.2 to 50 m. */
  private static final String RADAR = "fd0e00000001018400003930000014008813d204030719ff20c9";

  private static final String RADAR_INVALID =
      "fd2700000001018400003930000014008813d204030719ffcdcccc3dcdcccc3d0000000000000000"
          + "000000000000000001591c";
  private static final String RADAR_TOO_FAR =
      "fd0e000000010184000039300000140088138913030719ff0c93"; // 50.01 m
  private static final String RADAR_TOO_NEAR =
      "fd0e000000010184000039300000140088130300030719ff8bb2"; // 0.03 m
  private static final String LASER =
      "fd0e0000000101840000393000000500e8039001000219ff7730"; // id 2: 4 m

  /** Steps of 5°: 2.5 m ahead, none in reach, 10 m, and 0 in the last direction; of 0.2 to 10 m. */
  private static final String AROUND =
      "fda700000001014a010040420f0000000000fa00e903e803ffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "00001400e803030500000000000000000cb8dc";

  /** Steps of 1.5° from 30° to the left: 1, 2, 3 m. */
  private static final String FINE =
      "fda700000001014a010040420f00000000006400c8002c01ffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffff1400e80303000000c03f0000f0c10c8059";

  /** The same in 5°, but about north. */
  private static final String ABOUT_NORTH =
      "fd9e00000001014a010040420f00000000006400c8002c01ffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff"
          + "ffff1400e80303055b8c";

  private final MemoryLink link = new MemoryLink();

  private void say(String frame) {
    link.fromDevice(HexFormat.of().parseHex(frame));
  }

  private MavlinkRange range(MavlinkRange.Kind kind, int id) {
    MavlinkRange range = new MavlinkRange(link, kind, id);
    range.read(1_000_000);
    return range;
  }

  private static Optional<OptionalDouble> metres(MavlinkRange range) {
    return range.read(2_000_000).map(RangeFinder.Distance::rangeM);
  }

  @Test
  void range_radar_isMetresAtTheTimeOfArrival() {
    MavlinkRange range = range(MavlinkRange.Kind.RADAR, 7);
    say(RADAR);
    RangeFinder.Distance distance = range.read(2_000_000).orElseThrow();
    assertThat(distance.rangeM().orElseThrow()).isCloseTo(12.34, within(1e-9));
    assertThat(distance.measuredAtMicros()).isEqualTo(2_000_000);
    assertThat(range.malformed()).isZero();
  }

  @Test
  void range_beyondItsMost_isNothingInReach_belowItsLeast_isItsLeast() {
    MavlinkRange range = range(MavlinkRange.Kind.ANY, -1);
    say(RADAR_TOO_FAR);
    assertThat(metres(range)).contains(OptionalDouble.empty());
    say(RADAR_TOO_NEAR);
    assertThat(metres(range)).contains(OptionalDouble.of(0.2));
  }

  @Test
  void range_otherKindOrId_isNotHeard() {
    MavlinkRange radar = range(MavlinkRange.Kind.RADAR, -1);
    say(LASER);
    assertThat(metres(radar)).isEmpty();
    MavlinkRange second = range(MavlinkRange.Kind.ANY, 2);
    say(RADAR);
    assertThat(metres(second)).isEmpty();
    say(LASER);
    assertThat(metres(second)).contains(OptionalDouble.of(4.0));
  }

  @Test
  void range_measurementThatTheSensorCallsInvalid_isNone() {
    MavlinkRange range = range(MavlinkRange.Kind.RADAR, 7);
    say(RADAR);
    say(RADAR_INVALID);
    assertThat(range.read(2_000_000).orElseThrow().measuredAtMicros()).isEqualTo(2_000_000);
    say(RADAR_INVALID);
    assertThat(range.read(3_000_000).orElseThrow().measuredAtMicros())
        .as("the one before stays")
        .isEqualTo(2_000_000);
  }

  @Test
  void range_limitsThatCannotBe_areRefused() {
    MavlinkRange range = range(MavlinkRange.Kind.ANY, -1);
    link.fromDevice(
        new MavlinkFrame(132, 85, 14).i16(4, 500).i16(6, 20).i16(8, 100).i8(10, 3).from(1));
    assertThat(metres(range)).isEmpty();
    assertThat(range.malformed()).isEqualTo(1);
    assertThat(range.lastRefusal()).isEqualTo("DISTANCE_SENSOR from 500 to 20 cm");
  }

  private MavlinkProximity around(String frame) {
    MavlinkProximity scanner = new MavlinkProximity(link);
    scanner.read(1_000_000);
    say(frame);
    scanner.read(2_000_000);
    return scanner;
  }

  private static List<RangeScan.Beam> beams(MavlinkProximity scanner) {
    return scanner.read(2_000_000).orElseThrow().beams().beams();
  }

  @Test
  void around_measuredDirections_areBeamsToTheRightOfAhead() {
    MavlinkProximity scanner = around(AROUND);
    LaserScanner.Scan scan = scanner.read(2_000_000).orElseThrow();
    assertThat(scan.beams().minRange()).isEqualTo(0.2);
    assertThat(scan.beams().maxRange()).isEqualTo(10.0);
    assertThat(scan.beams().timestamp()).hasValue(2_000_000);
    List<RangeScan.Beam> beams = beams(scanner);
    assertThat(beams).as("72 less those not measured").hasSize(4);
    assertThat(beams.get(0).angle()).isZero();
    assertThat(beams.get(0).range()).hasValue(2.5);
    assertThat(beams.get(1).angle()).isCloseTo(Math.toRadians(-5.0), within(1e-12));
    assertThat(beams.get(1).range()).as("max + 1 is nothing").isEmpty();
    assertThat(beams.get(2).range()).hasValue(10.0);
    assertThat(beams.get(3).angle()).as("355° right").isCloseTo(Math.toRadians(5), within(1e-12));
    assertThat(beams.get(3).range()).as("touches the sensor").hasValue(0.2);
  }

  @Test
  void around_fineStepsAndOffset_areHeeded() {
    List<RangeScan.Beam> beams = beams(around(FINE));
    assertThat(beams).hasSize(3);
    assertThat(beams.get(0).angle()).isCloseTo(Math.toRadians(30.0), within(1e-9));
    assertThat(beams.get(2).angle()).isCloseTo(Math.toRadians(27.0), within(1e-9));
    assertThat(beams.get(2).range()).hasValue(3.0);
  }

  @Test
  void around_aboutNorth_isRefusedWithTheReason() {
    MavlinkProximity scanner = around(ABOUT_NORTH);
    assertThat(scanner.read(2_000_000)).isEmpty();
    assertThat(scanner.malformed()).isEqualTo(1);
    assertThat(scanner.lastRefusal())
        .isEqualTo("OBSTACLE_DISTANCE in frame 0; expected 12, MAV_FRAME_BODY_FRD");
  }

  @Test
  void around_leastBeyondMost_isRefusedWithBoth() {
    MavlinkProximity scanner = new MavlinkProximity(link);
    scanner.read(1_000_000);
    link.fromDevice(
        new MavlinkFrame(330, 23, 167).i16(152, 500).i16(154, 20).i8(157, 5).i8(166, 12).from(1));
    assertThat(scanner.read(2_000_000)).isEmpty();
    assertThat(scanner.lastRefusal())
        .isEqualTo("OBSTACLE_DISTANCE from 500 to 20 cm, in steps of 5.000 deg from 0.000 deg");
  }

  @Test
  void around_brokenFrame_isCountedAndTheNextIsRead() {
    String broken = FINE.substring(0, 60) + "00" + FINE.substring(62);
    MavlinkProximity scanner = around(broken);
    assertThat(scanner.read(2_000_000)).isEmpty();
    say(FINE);
    assertThat(beams(scanner)).hasSize(3);
    assertThat(scanner.malformed()).isPositive();
  }
}
