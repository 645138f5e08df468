package org.u2sa.world.modeller;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;

/** A post 2 m ahead, seen by a scanner at the vehicle's place: x is ahead. */
class HiddenGroundTest {
  private static final long NOW = 10_000_000L;
  private static final double STEP_RAD = Math.toRadians(1.0);

  private final HiddenGround hidden = new HiddenGround();

  @BeforeEach
  void seePost() {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = -90; i <= 90; i++) {
      ranges.add(Math.abs(i) <= 1 ? OptionalDouble.of(2.0) : OptionalDouble.empty());
    }
    RangeScan scan = new RangeScan().minRange(0.1).maxRange(10.0);
    scan.beams(-90 * STEP_RAD, STEP_RAD, ranges);
    SensorPose pose =
        new SensorPose(
            Point.ORIGIN, Point.ORIGIN, Point.of(1.0, 0.0, 0.0), Point.of(0.0, 1.0, 0.0));
    hidden.scan(scan, pose, 1.0, NOW);
  }

  @Test
  void hides_behindThePost_true() {
    hidden.lookFrom(0.0, 0.0, NOW);
    assertThat(hidden.hides(4.0, 0.0, 10.0)).isTrue();
  }

  @Test
  void hides_beforeAndBeside_false() {
    hidden.lookFrom(0.0, 0.0, NOW);
    assertThat(hidden.hides(1.9, 0.0, 10.0)).isFalse();
    assertThat(hidden.hides(2.1, 0.0, 10.0)).as("the post's own foot").isFalse();
    assertThat(hidden.hides(4.0, 1.5, 10.0)).isFalse();
    assertThat(hidden.hides(-4.0, 0.0, 10.0)).isFalse();
  }

  @Test
  void hides_fartherBehindThanTheReach_false() {
    hidden.lookFrom(0.0, 0.0, NOW);
    assertThat(hidden.hides(5.0, 0.0, 2.5)).isFalse();
    assertThat(hidden.hides(4.4, 0.0, 2.5)).isTrue();
  }

  @Test
  void hides_fromAnotherPlace_isBehindThePostAsSeenFromThere() {
    hidden.lookFrom(2.0, -2.0, NOW);
    assertThat(hidden.hides(2.0, 2.0, 10.0)).isTrue();
    assertThat(hidden.hides(4.0, 0.0, 10.0)).isFalse();
  }

  @Test
  void hides_scanOfLongAgo_false() {
    hidden.lookFrom(0.0, 0.0, NOW + 600_000L);
    assertThat(hidden.hides(4.0, 0.0, 10.0)).isFalse();
  }

  /** 0.4 m up, it looks down a ramp by 0.15 rad: its echo 2.7 m ahead is the lawn. */
  @Test
  void hides_behindTheGroundThatATiltedScannerSees_false() {
    RangeScan scan = new RangeScan().minRange(0.1).maxRange(10.0);
    scan.beams(0.0, STEP_RAD, List.of(OptionalDouble.of(2.7)));
    Point ahead = Point.of(Math.cos(0.15), 0.0, -Math.sin(0.15));
    Point scanner = Point.of(0.0, 0.0, 0.4);
    hidden.scan(
        scan, new SensorPose(scanner, Point.ORIGIN, ahead, Point.of(0.0, 1.0, 0.0)), 1.0, NOW);
    hidden.lookFrom(0.0, 0.0, NOW);
    assertThat(hidden.hides(4.0, 0.0, 10.0)).isFalse();

    RangeScan near = new RangeScan().minRange(0.1).maxRange(10.0);
    near.beams(0.0, STEP_RAD, List.of(OptionalDouble.of(1.2)));
    hidden.scan(
        near, new SensorPose(scanner, Point.ORIGIN, ahead, Point.of(0.0, 1.0, 0.0)), 1.0, NOW);
    hidden.lookFrom(0.0, 0.0, NOW);
    assertThat(hidden.hides(4.0, 0.0, 10.0)).as("higher than the ground").isTrue();
  }
}
