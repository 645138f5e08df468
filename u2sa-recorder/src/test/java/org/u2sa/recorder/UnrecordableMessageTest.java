package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.testkit.ServiceKit;

/** Messages that no file takes: the Recorder says so, and records the others. */
@Timeout(120)
class UnrecordableMessageTest {
  @Test
  void record_messagesTooLargeForTheWire_survivesAndFillsNoLog() throws InterruptedException {
    try (ServiceKit kit = new ServiceKit()) {
      Recorder recorder = kit.start(Recorder::new);
      for (int i = 0; i < 20; i++) {
        PointCloud cloud = new PointCloud().uid("c").x(0.0).y(0.0);
        kit.publish(
            Channels.SENSED_OBJECTS,
            cloud.points(Collections.nCopies(100_000, Point.of(1.25, 2.5, 3.75))));
      }
      kit.publish(Channels.STATE, new StateInformation().sensorName("gps").x(1.0));
      kit.advance(1.0);
      recorder.finish();
      recorder.join(); // on a busy machine, writing takes longer than a kill waits

      HealthReport last =
          kit.published(Channels.HEALTH).stream()
              .filter(report -> report.serviceName().equals(recorder.getServiceName()))
              .reduce((one, other) -> other)
              .orElseThrow();
      assertThat(last.status()).isEqualTo(ServiceStatus.STOPPED);
      assertThat(last.remarks()).anyMatch(remark -> remark.contains("cannot be recorded"));
      assertThat(kit.log(recorder.getServiceName()))
          .anyMatch(line -> line.contains("20 of them") || line.contains(", 20 not written"))
          .allSatisfy(line -> assertThat(line).hasSizeLessThan(5_000))
          .filteredOn(line -> line.contains("cannot be recorded"))
          .hasSize(5); // 1, 2, 4, 8, 16
    }
  }
}
