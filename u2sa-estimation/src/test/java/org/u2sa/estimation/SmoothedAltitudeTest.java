package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

class SmoothedAltitudeTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private double estimateOf(double measuredM) {
    kit.publish(Channels.SENSED_STATE, new StateInformation().sensorName("baro").z(measuredM));
    return kit.latest(Channels.STATE).orElseThrow().z().orElseThrow();
  }

  @Test
  void swap_forAnotherOfItsKind_goesOnFromTheAltitudeThatItKnew() {
    U2SAService before = kit.start(SmoothedAltitude::new);
    estimateOf(100.0);

    kit.swap(before, SmoothedAltitude::new);

    assertThat(estimateOf(200.0)).isEqualTo(110.0);
  }

  @Test
  void swap_afterOneThatKnowsNothing_beginsAnew() {
    U2SAService before = kit.start(PassThroughStateEstimator::new);
    estimateOf(100.0);

    kit.swap(before, SmoothedAltitude::new);

    assertThat(estimateOf(200.0)).isEqualTo(200.0);
  }
}
