package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ServiceKit;

class AllocatingControlTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  /** Heads into a current of its own speed, and is turned by 0.05 rad/s. */
  @Test
  void control_holdsStationInACurrent_rudderCountsBySpeedThroughTheWater() {
    kit.with("YAW WEIGHT", 1.0).with("YAW INERTIA", 100.0).with("YAW INTEGRAL TIME", 0.0);
    kit.start(AllocatingControl::new);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("RUDDER")
            .minimum(-100.0)
            .maximum(100.0)
            .moment(Point.of(0.0, 0.0, 100.0))
            .referenceSpeed(2.0));
    kit.publish(
        Channels.STATE,
        new StateInformation()
            .x(9.0)
            .y(54.0)
            .z(0.0)
            .xDot(0.0)
            .yDot(0.0)
            .psi(0.0)
            .psiDot(0.05)
            .fluidxDot(2.0));

    assertThat(kit.percent("RUDDER")).isBetween(-11.0, -9.0); // 100 kg m² times 2 1/s times 0.05
  }
}
