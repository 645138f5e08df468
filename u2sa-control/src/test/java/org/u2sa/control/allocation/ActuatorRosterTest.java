package org.u2sa.control.allocation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;

class ActuatorRosterTest {
  private final ActuatorRoster roster = new ActuatorRoster();

  private static ActuatorAnnouncement motor() {
    return new ActuatorAnnouncement()
        .actuatorName("MOTOR")
        .serviceName("Motor")
        .minimum(-100.0)
        .maximum(100.0)
        .force(Point.of(10.0, 0.0, 0.0))
        .renewal(0.25);
  }

  @Test
  void see_serviceFailed_isLostUntilItsNextAnnouncement() {
    roster.see(motor(), 0);
    roster.see(new HealthReport().serviceName("Motor").status(ServiceStatus.FAILED));
    assertThat(roster.lost(100_000)).containsExactly("MOTOR");

    roster.see(motor(), 200_000);
    assertThat(roster.lost(200_000)).isEmpty();
    assertThat(roster.present(200_000)).extracting(Effector::name).containsExactly("MOTOR");
  }

  @Test
  void see_anotherServiceFailed_changesNothing() {
    roster.see(motor(), 0);
    roster.see(new HealthReport().serviceName("Other").status(ServiceStatus.FAILED));
    assertThat(roster.lost(0)).isEmpty();
  }

  @Test
  void see_inventedActuatorsByTheHundred_forgetsThoseThatAreGoneAndNoOther() {
    for (int i = 0; i < 2_000; i++) {
      roster.see(motor(), i * 10_000L);
      roster.see(motor().actuatorName("invented " + i), i * 10_000L);
    }

    assertThat(roster.sound()).hasSizeLessThanOrEqualTo(500);
    assertThat(roster.present(19_990_000)).extracting(Effector::name).contains("MOTOR");
  }
}
