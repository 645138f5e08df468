package org.u2sa.gcs.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.schema.U2SAData;

/** Places of several stations' orders, for which the vehicle has no time. */
class OrdersUnderWayTest {
  private static final long NOW = 1_800_000_000_000_000L;

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

  @Test
  void send_parametersOfAStation_delayNoStopAndNoDisarming() {
    writeParameters(station, 100);
    assertThat(answers).hasSize(100 - 32).containsOnly("too many orders at once");

    for (VehicleOrders each : List.of(station, new VehicleOrders(all))) {
      published.clear();
      each.arm(false, this::answer);
      each.stop("test", this::answer);
      assertThat(published).hasExactlyElementsOfTypes(ArmCommand.class, EmergencyStop.class);
    }
  }

  /** The broker refuses more than 50 a second of a client, whoever sent them. */
  @Test
  void step_parametersOfAStation_comeSlowlyAndAfterAllOtherOrders() {
    all.step(NOW);
    writeParameters(station, 100);
    assertThat(published).hasSize(10);
    published.clear();
    VehicleOrders other = new VehicleOrders(all);
    for (int i = 0; i < 20; i++) {
      station.mission(new MissionOrder().action(MissionAction.RESUME), this::answer);
    }
    station.mission(new MissionOrder().action(MissionAction.PAUSE), this::answer);
    other.manual(false, "driver", this::answer);
    other.mission(new MissionOrder().action(MissionAction.PAUSE), this::answer);
    assertThat(published).isEmpty();

    all.step(NOW + 160_000);
    assertThat(published) // stations take turns
        .hasExactlyElementsOfTypes(
            MissionOrder.class, ManualOrder.class, MissionOrder.class, MissionOrder.class);
    assertThat(actions())
        .containsExactly(MissionAction.RESUME, MissionAction.RESUME, MissionAction.PAUSE);
    for (int turn = 1; turn <= 3; turn++) {
      all.step(NOW + 160_000 + 280_000 * turn);
    }
    assertThat(actions()).hasSize(22).endsWith(MissionAction.PAUSE);
    assertThat(published.get(published.size() - 1)).isInstanceOf(ConfigurationTransaction.class);
  }

  private List<MissionAction> actions() {
    return published.stream()
        .filter(MissionOrder.class::isInstance)
        .map(each -> ((MissionOrder) each).action())
        .toList();
  }

  @Test
  void step_placesOfAnsweredOrders_areFreeAgain() {
    all.step(NOW);
    writeParameters(station, 32);
    all.step(NOW + 2_000_000);
    all.step(NOW + 2_500_000);
    all.step(NOW + 2_900_000);
    answers.clear();
    all.step(NOW + 6_000_000);
    assertThat(answers).hasSize(32).allMatch(each -> each.startsWith("no answer"));
    writeParameters(station, 32);
    assertThat(answers).doesNotContain("too many orders at once");
  }

  @Test
  void send_stationsThatOrderAndLeave_neitherFillTheMemoryNorKeepOthersOut() {
    for (int i = 0; i < 10_000; i++) {
      VehicleOrders passing = new VehicleOrders(all);
      passing.arm(false, this::answer);
      writeParameters(passing, 1);
      passing.close();
    }
    assertThat(answers).hasSize(10_000 + 10 - 16 * 32 * 8).containsOnly("its station has left");
    answers.clear();
    published.clear();
    station.mission(new MissionOrder().action(MissionAction.PAUSE), this::answer);
    all.step(NOW);
    assertThat(published).hasExactlyElementsOfTypes(MissionOrder.class);
  }

  @Test
  void take_answerOfAnotherServiceToAConfiguration_waitsForTheServiceAsked() {
    all.step(NOW);
    writeParameters(station, 1);
    String id = ((ConfigurationTransaction) published.get(0)).requestId();
    ConfigurationTransactionResult lie =
        new ConfigurationTransactionResult().requestId(id).serviceName("Liar").accepted(true);
    all.take(lie.reason("a lie"));
    all.step(NOW + 100_000);
    assertThat(answers).isEmpty();

    ConfigurationTransactionResult answer =
        new ConfigurationTransactionResult().requestId(id).serviceName("Control").accepted(false);
    all.take(answer.reason("too large"));
    all.step(NOW + 200_000);
    assertThat(answers).containsExactly("too large");
  }
}
