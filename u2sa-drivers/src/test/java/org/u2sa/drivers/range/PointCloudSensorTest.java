package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.PointCloudSensor;
import org.u2sa.device.port.PointScanner;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.testkit.ServiceKit;

/** A scanner on a mast of 1 m. */
class PointCloudSensorTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void end() {
    kit.close();
  }

  private Optional<PointCloud> published(Point... seen) {
    kit.with("MOUNTED Z", -1.0);
    PointScanner scanner = now -> Optional.of(new PointScanner.Cloud(1, List.of(seen)));
    kit.start(context -> new PointCloudSensor(context, scanner));
    kit.advance(0.5);
    return kit.latest(Channels.SENSED_OBJECTS).map(PointCloud.class::cast);
  }

  @Test
  void step_obstacleAmongGroundAndBranches_isPublishedAlone() {
    PointCloud cloud =
        published(
                Point.of(5.0, 1.0, 0.95), // 5 cm above the reference point
                Point.of(5.0, 1.0, 0.2),
                Point.of(5.0, 1.0, -1.5), // 2.5 m above it
                Point.of(0.2, 0.1, 0.0), // the mast
                Point.of(80.0, 0.0, 0.0))
            .orElseThrow();

    assertThat(cloud.points()).containsExactly(Point.of(5.0, 1.0, -0.8));
    assertThat(cloud.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(cloud.uid()).isEqualTo("PointCloudSensor");
    assertThat(cloud.x()).isCloseTo(5.0, within(1e-9));
    assertThat(cloud.timestamp()).hasValue(1);
  }

  @Test
  void step_manyPointsInACell_nearestIsKept() {
    PointCloud cloud =
        published(Point.of(3.19, 0.05, 0.0), Point.of(3.05, 0.05, 0.0), Point.of(3.3, 0.05, 0.0))
            .orElseThrow();

    assertThat(cloud.points())
        .containsExactly(Point.of(3.05, 0.05, -1.0), Point.of(3.3, 0.05, -1.0));
  }

  @Test
  void step_moreThanMaxPoints_farthestAreLeftOut() {
    kit.with("MAX POINTS", 1);

    assertThat(published(Point.of(4.0, 0.0, 0.0), Point.of(3.0, 0.0, 0.0)).orElseThrow().points())
        .containsExactly(Point.of(3.0, 0.0, -1.0));
  }

  @Test
  void step_groundOnly_publishesAnEmptyCloudAtItsOwnPlace() {
    PointCloud cloud = published(Point.of(5.0, 1.0, 1.0)).orElseThrow();

    assertThat(cloud.points()).isEmpty();
    assertThat(cloud.center()).isEqualTo(Point.of(0.0, 0.0, -1.0));
    assertThat(cloud.isScan()).isTrue();
  }
}
