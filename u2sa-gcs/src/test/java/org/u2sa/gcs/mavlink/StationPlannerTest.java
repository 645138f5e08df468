package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.mavlink.AvailableModes;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.mission.MissionOrder;

/** Classes of the Path Planner as modes. */
class StationPlannerTest {
  private static final String USUAL = "org.u2sa.planning.PathPlanner";
  private static final String OWN = "com.acme.WavePlanner"; // of a jar
  private static final long OWN_MODE = 4L << 16 | 11L << 24; // PX4: auto, external 1
  private static final long MISSION = 4L << 16 | 4L << 24;
  private final BridgeKit kit = BridgeKit.rover().ready();

  @BeforeEach
  void discover() {
    announce(kit, USUAL);
  }

  private static void announce(BridgeKit kit, String running) {
    DiscoveryResponse response =
        new DiscoveryResponse()
            .serviceType("PATH_PLANNER")
            .status(ServiceStatus.RUNNING)
            .className(running)
            .choices(List.of(OWN, USUAL, "org.u2sa.planning.VectorFieldPlanner"));
    response.serviceName("PathPlanner");
    kit.says(response);
    kit.step();
  }

  private void answerSwap(boolean accepted, String reason) {
    ServiceOrder order = kit.orders(ServiceOrder.class).get(0);
    assertThat(order.action()).isEqualTo(ServiceAction.SWAP);
    assertThat(order.serviceName()).isEqualTo("PathPlanner");
    kit.says(
        new ServiceOrderResult()
            .requestId(order.requestId())
            .serviceName("PathPlanner")
            .accepted(accepted)
            .reason(reason));
    kit.step();
  }

  private long heard() {
    kit.received(Heartbeat.class);
    kit.advance(1.1);
    return kit.received(Heartbeat.class).get(0).customMode();
  }

  @Test
  void availableModes_ofAJarsPlanner_namesItsClass() {
    assertThat(kit.vehicle.telemetry.modes()).isEqualTo(7);
    assertThat((AvailableModes) kit.vehicle.telemetry.mode(6).orElseThrow())
        .isEqualTo(new AvailableModes(7, 6, 0, OWN_MODE, 0, "WavePlanner"));
    assertThat(kit.vehicle.telemetry.mode(8)).isEmpty();
    BridgeKit ardupilot = new BridgeKit(Identity.ARDUPILOT, VehicleKind.ROVER).ready();
    announce(ardupilot, USUAL);
    int modes = ardupilot.vehicle.telemetry.modes();
    assertThat(((AvailableModes) ardupilot.vehicle.telemetry.mode(modes - 1).orElseThrow()))
        .isEqualTo(new AvailableModes(modes, modes - 1, 0, 100, 0, "WavePlanner"));
  }

  @Test
  void setMode_planner_swapsAndGoesOnWithTheMission() {
    kit.command(176, 1, 4, 11);
    assertThat(kit.received(CommandAck.class)).isEmpty();
    answerSwap(true, "");

    assertThat(kit.orders(DiscoveryRequest.class)).isNotEmpty();
    announce(kit, OWN);
    assertThat(kit.received(CommandAck.class).get(0).result().entry())
        .isEqualTo(MavResult.MAV_RESULT_ACCEPTED);
    assertThat(heard()).isEqualTo(OWN_MODE);
  }

  @Test
  void setMode_plannerThatIsRefused_isDeniedWithTheReason() {
    kit.command(176, 1, 4, 11);
    answerSwap(false, "WavePlanner: variable \"HEIGHT\" is missing");

    assertThat(kit.received(CommandAck.class).get(0).result().entry())
        .isEqualTo(MavResult.MAV_RESULT_DENIED);
    assertThat(kit.texts()).contains("variable \"HEIGHT\" is missing");
    assertThat(heard()).isEqualTo(MISSION);
  }

  @Test
  void setMode_missionWhileAnotherPlannerRuns_swapsBackAndContinueDoesNot() {
    announce(kit, OWN);
    kit.command(193, 1); // continue
    assertThat(kit.orders(ServiceOrder.class)).isEmpty();

    kit.command(176, 1, 4, 4);
    ServiceOrder order = (ServiceOrder) kit.published.get(kit.published.size() - 1);
    assertThat(order.className()).hasValue(USUAL);
    assertThat(kit.orders(MissionOrder.class)).isEmpty();
  }
}
