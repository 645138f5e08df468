package org.u2sa.vision.laser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.testkit.ServiceKit;

class ScanClustersTest {
  private static final double STEP = Math.toRadians(0.5);

  private final ServiceKit kit = new ServiceKit();
  private final Random random = new Random(3);

  /** A round thing, in the scanner's plane: x ahead, y left. */
  private record Round(double x, double y, double radius) {
    double range(double angle) {
      double along = x * Math.cos(angle) + y * Math.sin(angle);
      double aside = x * Math.sin(angle) - y * Math.cos(angle);
      double root = radius * radius - aside * aside;
      return root < 0.0 || along < 0.0 ? 1e9 : along - Math.sqrt(root);
    }
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private RangeScan scan(double noise, Round... things) {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (double angle = -Math.PI; angle < Math.PI - 0.5 * STEP; angle += STEP) {
      double range = 1e9;
      for (Round thing : things) {
        range = Math.min(range, thing.range(angle));
      }
      ranges.add(
          range > 12.0
              ? OptionalDouble.empty()
              : OptionalDouble.of(range + noise * random.nextGaussian()));
    }
    RangeScan scan = new RangeScan().sensorName("Lidar").maxRange(12.0).x(0.5).z(-0.3);
    scan.beams(-Math.PI, STEP, ranges).timestamp(1_000L);
    return scan;
  }

  private List<ObjectDescription> objects(RangeScan scan) {
    kit.start(ScanClusters::new);
    kit.publish(Channels.SCANS, scan);
    return kit.published(Channels.SENSED_OBJECTS);
  }

  @Test
  void onScan_twoBarrels_areCirclesWhereTheyStand() {
    List<ObjectDescription> objects =
        objects(scan(0.005, new Round(3.0, 1.0, 0.3), new Round(4.0, -1.5, 0.3)));
    assertThat(objects).hasSize(2);
    Circle right = (Circle) objects.get(0); // the scan begins behind and turns to the left
    assertThat(right.x()).isCloseTo(4.5, within(0.05));
    assertThat(right.y()).isCloseTo(-1.5, within(0.05));
    assertThat(right.radius()).isCloseTo(0.3, within(0.05));
    Circle left = (Circle) objects.get(1);
    assertThat(left.x()).isCloseTo(3.5, within(0.04));
    assertThat(left.y()).isCloseTo(1.0, within(0.04));
    assertThat(left.objectType()).isEmpty();
    assertThat(left.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(left.timestamp()).hasValue(1_000L);
  }

  @Test
  void onScan_manyNoisyScans_errorsAreAsLargeAsTheirSigmas() {
    kit.start(ScanClusters::new);
    for (int i = 0; i < 60; i++) {
      kit.publish(Channels.SCANS, scan(0.02, new Round(3.0, 0.5, 0.3)));
    }
    double squares = 0.0;
    List<ObjectDescription> objects = kit.published(Channels.SENSED_OBJECTS);
    for (ObjectDescription object : objects) {
      Point sigma = object.motion().sigma().orElseThrow();
      squares += Math.pow((object.x() - 3.5) / sigma.x(), 2.0);
    }
    assertThat(objects).hasSize(60);
    assertThat(Math.sqrt(squares / 60.0)).isBetween(0.4, 1.6);
  }

  @Test
  void onScan_thingStraightBehind_isOneAlthoughTheScanBeginsThere() {
    List<ObjectDescription> objects = objects(scan(0.0, new Round(-3.0, 0.0, 0.3)));
    assertThat(objects).hasSize(1);
    assertThat(objects.get(0).x()).isCloseTo(-2.5, within(0.05));
    assertThat(((Circle) objects.get(0)).radius()).isCloseTo(0.3, within(0.05));
  }

  @Test
  void onScan_wallAndSingleEcho_areNoObjects() {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < 181; i++) {
      double angle = Math.toRadians(i - 90);
      boolean isWall = Math.abs(angle) < 0.8;
      ranges.add(
          isWall
              ? OptionalDouble.of(4.0 / Math.cos(angle))
              : i == 20 ? OptionalDouble.of(2.0) : OptionalDouble.empty());
    }
    RangeScan scan = new RangeScan().sensorName("Lidar").maxRange(12.0);
    scan.beams(-Math.PI / 2.0, Math.toRadians(1.0), ranges).timestamp(1_000L);
    assertThat(objects(scan)).isEmpty();
  }

  @Test
  void onScan_pitchedForward_groundIsNoObject() {
    kit.with("GROUND BELOW", 0.1).start(ScanClusters::new);
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    state.phi(0.0).theta(-0.15).timestamp(900L);
    kit.publish(Channels.STATE, state);
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < 21; i++) { // a short strip of ground 2.6 m ahead
      ranges.add(OptionalDouble.of(2.6));
    }
    RangeScan scan = new RangeScan().sensorName("Lidar").maxRange(12.0).z(-0.3);
    scan.beams(-0.1, 0.01, ranges).timestamp(1_000L);
    kit.publish(Channels.SCANS, scan);
    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
    state = state.copy();
    state.theta(0.0).timestamp(1_900L);
    kit.publish(Channels.STATE, state);
    scan = (RangeScan) scan.copy();
    scan.timestamp(2_000L);
    kit.publish(Channels.SCANS, scan);
    assertThat(kit.published(Channels.SENSED_OBJECTS)).hasSize(1);
  }

  @Test
  void onScan_withoutTime_isTrouble() {
    kit.start(ScanClusters::new);
    RangeScan scan =
        new RangeScan().sensorName("Lidar").maxRange(12.0).referenceFrame(ReferenceFrame.LOCAL_NED);
    scan.beams(0.0, 0.1, List.of()).timestamp(1L);
    kit.publish(Channels.SCANS, scan);
    kit.advance(2.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElseThrow())
        .contains("Lidar");
  }
}
