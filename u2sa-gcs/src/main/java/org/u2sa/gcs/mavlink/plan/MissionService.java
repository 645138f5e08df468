package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.MissionSetCurrent;
import io.dronefleet.mavlink.common.MissionWritePartialList;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;

/**
 * Mission protocol for one station (mavlink.io/en/services/mission): mission, fence and rally
 * points.
 */
public final class MissionService {
  private static final int MISSION = MissionAnswers.MISSION;
  private static final int FENCE = MissionAnswers.FENCE;
  private static final int RALLY = MissionAnswers.RALLY;
  private static final int ALL = 255; // MAV_MISSION_TYPE

  private final VehicleOrders orders;
  private final PlanBook book;
  private final GroundStation station;
  private final MissionAnswers answers;
  private final MissionItems mission;
  private final FenceItems fence;
  private final FenceItems rally;
  private final Map<Integer, ItemTransfer> transfers;

  /**
   * @param book mission, shared by all stations like the fence's
   */
  public MissionService(
      VehicleStatus vehicle,
      VehicleOrders orders,
      PlanBook book,
      FenceBook fences,
      GroundStation station) {
    this.orders = orders;
    this.book = book;
    this.station = station;
    answers = new MissionAnswers(station);
    mission = new MissionItems(vehicle, orders, book, answers);
    fence = new FenceItems(FENCE, "fence", orders, fences, answers);
    rally = new FenceItems(RALLY, "rally points", orders, fences, answers);
    transfers =
        Map.of(
            MISSION, new ItemTransfer(MISSION, "mission", mission, answers),
            FENCE, new ItemTransfer(FENCE, "fence", fence, answers),
            RALLY, new ItemTransfer(RALLY, "rally points", rally, answers));
  }

  /** Handles a message; false if it does not belong to this protocol. */
  @SuppressWarnings("deprecation") // stations still send these
  public boolean handle(Object message, Sender from) {
    if (message instanceof MissionRequestList request) {
      with(request.missionType().value(), from, items -> items.list(from));
    } else if (message instanceof MissionRequestInt request) {
      with(request.missionType().value(), from, items -> items.item(request.seq(), from));
    } else if (message instanceof MissionRequest request) {
      with(request.missionType().value(), from, items -> items.item(request.seq(), from));
    } else if (message instanceof MissionCount count) {
      with(count.missionType().value(), from, items -> items.begin(count.count(), from));
    } else if (message instanceof MissionItemInt item) {
      Optional.ofNullable(transfers.get(item.missionType().value()))
          .ifPresent(items -> items.take(item, from));
    } else if (message instanceof MissionClearAll clear) {
      clear(clear.missionType().value(), from);
    } else if (message instanceof MissionSetCurrent request) {
      setCurrent(request.seq());
    } else if (message instanceof MissionWritePartialList) {
      answers.acknowledge(MavMissionResult.MAV_MISSION_UNSUPPORTED, MISSION, from);
    } else {
      return message instanceof MissionAck;
    }
    return true;
  }

  private void with(int type, Sender from, Consumer<ItemTransfer> act) {
    ItemTransfer items = transfers.get(type);
    if (items == null) {
      answers.refuseType(type, from);
    } else {
      act.accept(items);
    }
  }

  private void clear(int type, Sender from) {
    if (type == MISSION) {
      mission.clear(type, from);
    } else if (type == FENCE) {
      fence.clear(type, from);
    } else if (type == RALLY) {
      rally.clear(type, from);
    } else if (type == ALL || type == MavMissionType.MAV_MISSION_TYPE_ALL.ordinal()) {
      fence.removeAll(() -> mission.clear(type, from), type, from);
    } else {
      answers.refuseType(type, from);
    }
  }

  private void setCurrent(int seq) {
    Optional<String> goal = book.goal(seq);
    if (goal.isEmpty()) {
      station.text(MavSeverity.MAV_SEVERITY_ERROR, "no mission item " + seq);
      return;
    }
    orders.mission(
        new MissionOrder().action(MissionAction.GOTO).uid(goal.get()),
        (accepted, text) -> {
          if (!accepted) {
            station.text(MavSeverity.MAV_SEVERITY_ERROR, "mission item not set: " + text);
          }
        });
  }

  /** Requests missing items again, and acknowledges completed uploads. */
  public void step(long micros) {
    transfers.values().forEach(items -> items.step(micros));
    mission.step(micros);
  }
}
