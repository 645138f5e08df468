package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.FenceState;

/** A station that transfers areas or rally points, and the Safety Manager that answers it. */
final class FenceStation {
  private final Supplier<BridgeKit> kit;
  private final MavMissionType type;

  FenceStation(Supplier<BridgeKit> kit, MavMissionType type) {
    this.kit = kit;
    this.type = type;
  }

  void upload(List<MissionItemInt> items) {
    kit.get()
        .send(
            MissionCount.builder()
                .targetSystem(1)
                .targetComponent(1)
                .count(items.size())
                .missionType(type)
                .build());
    for (int i = 0; i < items.size(); i++) {
      MissionRequestInt asked = kit.get().received(MissionRequestInt.class).get(0);
      assertThat(asked.seq()).isEqualTo(i);
      assertThat(asked.missionType().entry()).isEqualTo(type);
      kit.get().send(items.get(i));
    }
  }

  List<MissionItemInt> downloaded() {
    kit.get()
        .send(
            MissionRequestList.builder()
                .targetSystem(1)
                .targetComponent(1)
                .missionType(type)
                .build());
    MissionCount count = kit.get().received(MissionCount.class).get(0);
    assertThat(count.missionType().entry()).isEqualTo(type);
    List<MissionItemInt> items = new ArrayList<>();
    for (int i = 0; i < count.count(); i++) {
      kit.get()
          .send(
              MissionRequestInt.builder()
                  .targetSystem(1)
                  .targetComponent(1)
                  .seq(i)
                  .missionType(type)
                  .build());
      items.addAll(kit.get().received(MissionItemInt.class));
    }
    return items;
  }

  /** The Safety Manager's answer to the order that the upload led to. */
  FenceOrder answer(boolean accepted, String outcome) {
    FenceOrder order = kit.get().orders(FenceOrder.class).get(0);
    if (accepted) {
      FenceState now = new FenceState();
      order.fence().ifPresent(xml -> now.fence(xml).file(order.file().orElseThrow()));
      kit.get().says(now);
    }
    kit.get()
        .says(
            new FenceOrderResult()
                .requestId(order.requestId())
                .serviceName("SafetyManager")
                .accepted(accepted)
                .outcome(outcome));
    kit.get().step();
    return order;
  }
}
