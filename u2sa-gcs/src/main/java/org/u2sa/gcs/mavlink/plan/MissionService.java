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
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;

/**
 * The mission protocol towards one station (mavlink.io/en/services/mission). Fences and rally
 * points are refused by name: the Safety Manager reads its fence from a file.
 */
public final class MissionService {
  private static final int MISSION = MavMissionType.MAV_MISSION_TYPE_MISSION.ordinal();
  private static final int FENCE = MavMissionType.MAV_MISSION_TYPE_FENCE.ordinal();
  private static final int MAX_ITEMS = 1000;
  private static final long REPORT_MICROS = 1_000_000;
  private static final long RETRY_MICROS = 700_000;
  private static final int MAX_RETRIES = 25;

  /** An upload under way. */
  private static final class Incoming {
    private final Sender from;
    private final int count;
    private final List<MissionItem> items = new ArrayList<>();
    private long askedMicros;
    private int retries;

    Incoming(Sender from, int count) {
      this.from = from;
      this.count = count;
    }
  }

  /** A mission that is acknowledged as soon as it can be read back. */
  private record Confirmation(String origin, int type, Sender to, long deadlineMicros) {}

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final PlanBook book;
  private final GroundStation station;
  private Optional<Incoming> incoming = Optional.empty();
  private Optional<Confirmation> confirmation = Optional.empty();
  private List<MissionItem> outgoing = List.of(); // as they were when the list was requested
  private long nowMicros;

  /**
   * @param book shared by all stations
   */
  public MissionService(
      VehicleStatus vehicle, VehicleOrders orders, PlanBook book, GroundStation station) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.book = book;
    this.station = station;
  }

  /** Handles a message; false if it is not of this protocol. */
  @SuppressWarnings("deprecation") // stations still send these
  public boolean handle(Object message, Sender from) {
    if (message instanceof MissionRequestList request) {
      list(request.missionType().value(), from);
    } else if (message instanceof MissionRequestInt request) {
      item(request.seq(), request.missionType().value(), from);
    } else if (message instanceof MissionRequest request) {
      item(request.seq(), request.missionType().value(), from);
    } else if (message instanceof MissionCount count) {
      begin(count, from);
    } else if (message instanceof MissionItemInt item) {
      take(item, from);
    } else if (message instanceof MissionClearAll clear) {
      clear(clear.missionType().value(), from);
    } else if (message instanceof MissionSetCurrent request) {
      setCurrent(request.seq());
    } else if (message instanceof MissionWritePartialList) {
      acknowledge(MavMissionResult.MAV_MISSION_UNSUPPORTED, MISSION, from);
    } else {
      return message instanceof MissionAck;
    }
    return true;
  }

  private void list(int type, Sender from) {
    if (type != MISSION) {
      refuseType(type, from, type == FENCE);
      return;
    }
    try {
      outgoing = book.listed();
    } catch (PlanRefusal e) {
      outgoing = List.of();
      station.text(MavSeverity.MAV_SEVERITY_WARNING, "mission not shown: " + e.getMessage());
    }
    station.send(
        MissionCount.builder()
            .targetSystem(from.system())
            .targetComponent(from.component())
            .count(outgoing.size())
            .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
            .build());
  }

  private void refuseType(int type, Sender from, boolean isFence) {
    station.text(
        MavSeverity.MAV_SEVERITY_WARNING,
        isFence
            ? "fence: the vehicle reads it from the file of FENCE of the SafetyManager"
            : "rally points: the vehicle has none; it returns to its home");
    acknowledge(MavMissionResult.MAV_MISSION_UNSUPPORTED, type, from);
  }

  private void item(int seq, int type, Sender from) {
    if (type != MISSION || seq < 0 || seq >= outgoing.size()) {
      acknowledge(MavMissionResult.MAV_MISSION_INVALID_SEQUENCE, type, from);
      return;
    }
    boolean isCurrent = vehicle.current().flatMap(book::index).filter(at -> at == seq).isPresent();
    station.send(outgoing.get(seq).message(seq, isCurrent, from));
  }

  private void begin(MissionCount count, Sender from) {
    int type = count.missionType().value();
    if (type != MISSION) {
      refuseType(type, from, type == FENCE);
    } else if (incoming.filter(other -> !other.from.equals(from)).isPresent()) {
      acknowledge(MavMissionResult.MAV_MISSION_ERROR, type, from);
    } else if (count.count() > MAX_ITEMS) {
      station.text(
          MavSeverity.MAV_SEVERITY_ERROR,
          "mission of " + count.count() + " items: expected at most " + MAX_ITEMS);
      acknowledge(MavMissionResult.MAV_MISSION_NO_SPACE, type, from);
    } else if (count.count() == 0) {
      clear(type, from);
    } else {
      incoming = Optional.of(new Incoming(from, count.count()));
      ask(incoming.get());
    }
  }

  private void ask(Incoming upload) {
    upload.askedMicros = nowMicros;
    station.send(
        MissionRequestInt.builder()
            .targetSystem(upload.from.system())
            .targetComponent(upload.from.component())
            .seq(upload.items.size())
            .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
            .build());
  }

  private void take(MissionItemInt item, Sender from) {
    if (incoming.isEmpty() || !incoming.get().from.equals(from)) {
      return; // a repetition after the acknowledgement, or nobody asked
    }
    Incoming upload = incoming.get();
    if (item.seq() != upload.items.size()) {
      return; // a repetition: the item asked for is on its way, or is asked for again
    }
    upload.items.add(MissionItem.of(item));
    upload.retries = 0;
    if (upload.items.size() < upload.count) {
      ask(upload);
    } else {
      incoming = Optional.empty();
      replace(upload.items, from);
    }
  }

  private void replace(List<MissionItem> items, Sender from) {
    PlanBook.Upload upload;
    try {
      upload = book.read(items);
    } catch (PlanRefusal e) {
      station.text(MavSeverity.MAV_SEVERITY_ERROR, e.getMessage());
      acknowledge(e.result(), MISSION, from);
      return;
    }
    boolean goesOn = vehicle.isArmed() && vehicle.mode() == VehicleMode.MISSION;
    orders.mission(
        new MissionOrder()
            .action(MissionAction.REPLACE)
            .file(upload.plan().origin())
            .goals(upload.xml())
            .now(goesOn),
        (accepted, text) -> {
          if (accepted) {
            book.accepted(upload.plan());
            if (!upload.details().isEmpty()) {
              station.text(
                  MavSeverity.MAV_SEVERITY_WARNING,
                  "left out: " + PlanRefusal.some(upload.details()));
            }
            confirm(upload.plan().origin(), MISSION, from);
          } else {
            station.text(MavSeverity.MAV_SEVERITY_ERROR, "mission refused: " + text);
            acknowledge(MavMissionResult.MAV_MISSION_ERROR, MISSION, from);
          }
        });
  }

  private void confirm(String origin, int type, Sender to) {
    confirmation = Optional.of(new Confirmation(origin, type, to, nowMicros + REPORT_MICROS));
    vehicle.wantReport();
  }

  /** A mission has at least one goal, so a cleared one has a place to hold at. */
  private void clear(int type, Sender from) {
    if (type != MISSION && type != MavMissionType.MAV_MISSION_TYPE_ALL.ordinal() && type != 255) {
      refuseType(type, from, type == FENCE);
      return;
    }
    Optional<StateInformation> here =
        vehicle.state().filter(state -> state.x().isPresent() && state.y().isPresent());
    if (here.isEmpty()) {
      station.text(MavSeverity.MAV_SEVERITY_ERROR, "mission not cleared: no position to hold at");
      acknowledge(MavMissionResult.MAV_MISSION_ERROR, type, from);
      return;
    }
    String goal =
        String.format(
            Locale.ROOT,
            "<mission><waypoint><name>held</name><reference>%s</reference><x>%.9f</x><y>%.9f</y></waypoint></mission>",
            here.get().referenceFrame(),
            here.get().x().getAsDouble(),
            here.get().y().getAsDouble());
    orders.mission(
        new MissionOrder().action(MissionAction.REPLACE).file(PlanBook.CLEARED).goals(goal),
        (accepted, text) -> {
          if (accepted) {
            confirm(PlanBook.CLEARED, type, from);
          } else {
            station.text(MavSeverity.MAV_SEVERITY_ERROR, "mission not cleared: " + text);
            acknowledge(MavMissionResult.MAV_MISSION_ERROR, type, from);
          }
        });
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

  /** Asks again for what did not arrive. */
  public void step(long micros) {
    nowMicros = micros;
    confirmation
        .filter(each -> micros > each.deadlineMicros() || isReported(each.origin()))
        .ifPresent(
            each -> {
              confirmation = Optional.empty();
              acknowledge(MavMissionResult.MAV_MISSION_ACCEPTED, each.type(), each.to());
            });
    if (incoming.isEmpty() || micros - incoming.get().askedMicros < RETRY_MICROS) {
      return;
    }
    Incoming upload = incoming.get();
    if (upload.retries++ < MAX_RETRIES) {
      ask(upload);
    } else {
      incoming = Optional.empty();
      acknowledge(MavMissionResult.MAV_MISSION_OPERATION_CANCELLED, MISSION, upload.from);
    }
  }

  private boolean isReported(String origin) {
    return vehicle.report().filter(report -> report.mission().equals(origin)).isPresent();
  }

  private void acknowledge(MavMissionResult result, int type, Sender to) {
    station.send(
        MissionAck.builder()
            .targetSystem(to.system())
            .targetComponent(to.component())
            .type(result)
            .missionType(EnumValue.create(MavMissionType.class, type))
            .build());
  }
}
