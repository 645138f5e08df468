package org.u2sa.gcs.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.schema.U2SAData;

/** Places of several stations' orders, for which the vehicle has no time. */
class OrdersUnderWayTest {
  private final List<U2SAData> published = new ArrayList<>();
  private final List<String> answers = new ArrayList<>();
  private final OrdersUnderWay all =
      new OrdersUnderWay((channel, message) -> published.add(message), "tester");
  private final VehicleOrders station = new VehicleOrders(all);

  private void answer(boolean accepted, String text) {
    answers.add(text);
  }

  private void writeParameters(VehicleOrders from, int count) {
    for (int i = 0; i < count; i++) {
      from.configure(new ConfigurationTransaction().serviceName("Control"), this::answer);
    }
  }

  private void publishesEveryOrder(VehicleOrders from) {
    published.clear();
    answers.clear();
    from.arm(false, this::answer);
    from.manual(false, "driver", this::answer);
    from.stop("test", this::answer);
    from.mission(new MissionOrder().action(MissionAction.PAUSE), this::answer);
    from.mission(new MissionOrder().action(MissionAction.RETURN), this::answer);
    from.mission(new MissionOrder().action(MissionAction.RESUME), this::answer);
    assertThat(answers).doesNotContain("too many orders at once");
    assertThat(published)
        .hasExactlyElementsOfTypes(
            ArmCommand.class,
            ManualOrder.class,
            EmergencyStop.class,
            MissionOrder.class,
            MissionOrder.class,
            MissionOrder.class);
  }

  @Test
  void send_parametersBeyondTheirPlaces_delayNoOtherOrderOfAnyStation() {
    writeParameters(station, 100);
    assertThat(published).hasSize(32);
    assertThat(answers).hasSize(68).containsOnly("too many orders at once");

    publishesEveryOrder(station);
    publishesEveryOrder(new VehicleOrders(all));
    all.step(3_000_001);
    published.clear();
    writeParameters(station, 100);
    assertThat(published).hasSize(32);
  }

  @Test
  void send_stationsThatOrderAndLeave_neitherFillTheMemoryNorKeepOthersOut() {
    for (int i = 0; i < 10_000; i++) {
      VehicleOrders passing = new VehicleOrders(all);
      writeParameters(passing, 1);
      passing.close();
    }
    assertThat(answers).hasSize(10_000 - 16 * 32 * 6).containsOnly("its station has left");
    publishesEveryOrder(station);
  }
}
