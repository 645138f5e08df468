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
  private static final int MISSION = MissionAnswers.MISSION;
  private static final long REPORT_MICROS = 1_000_000;

  /** A mission that is acknowledged as soon as it can be read back. */
  private record Confirmation(String origin, int type, Sender to, long deadlineMicros) {}

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final PlanBook book;
  private final GroundStation station;
  private final MissionAnswers answers;
  private final MissionUpload upload;
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
    answers = new MissionAnswers(station);
    upload = new MissionUpload(answers, this::replace);
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
      upload.take(item, from);
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

  private void list(int type, Sender from) {
    if (type != MISSION) {
      answers.refuseType(type, from);
      return;
    }
    try {
      outgoing = book.listed();
    } catch (PlanRefusal e) {
      outgoing = List.of();
      answers.warn("mission not shown: " + e.getMessage());
    }
    station.send(
        MissionCount.builder()
            .targetSystem(from.system())
            .targetComponent(from.component())
            .count(outgoing.size())
            .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
            .build());
  }

  private void item(int seq, int type, Sender from) {
    if (type != MISSION || seq < 0 || seq >= outgoing.size()) {
      answers.acknowledge(MavMissionResult.MAV_MISSION_INVALID_SEQUENCE, type, from);
      return;
    }
    boolean isCurrent = vehicle.current().flatMap(book::index).filter(at -> at == seq).isPresent();
    station.send(outgoing.get(seq).message(seq, isCurrent, from));
  }

  private void begin(MissionCount count, Sender from) {
    int type = count.missionType().value();
    if (type != MISSION) {
      answers.refuseType(type, from);
    } else if (count.count() == 0) {
      clear(type, from);
    } else {
      upload.begin(count.count(), from);
    }
  }

  private void replace(List<MissionItem> items, Sender from) {
    PlanBook.Upload read;
    try {
      read = book.read(items);
    } catch (PlanRefusal e) {
      answers.refuse(e.result(), e.getMessage(), MISSION, from);
      return;
    }
    boolean goesOn = vehicle.isArmed() && vehicle.mode() == VehicleMode.MISSION;
    orders.mission(
        new MissionOrder()
            .action(MissionAction.REPLACE)
            .file(read.plan().origin())
            .goals(read.xml())
            .now(goesOn),
        (accepted, text) -> {
          if (accepted) {
            book.accepted(read.plan());
            if (!read.details().isEmpty()) {
              answers.warn("left out: " + PlanRefusal.some(read.details()));
            }
            confirm(read.plan().origin(), MISSION, from);
          } else {
            refuse("mission refused: " + text, MISSION, from);
          }
        });
  }

  private void refuse(String why, int type, Sender to) {
    answers.refuse(MavMissionResult.MAV_MISSION_ERROR, why, type, to);
  }

  private void confirm(String origin, int type, Sender to) {
    confirmation = Optional.of(new Confirmation(origin, type, to, nowMicros + REPORT_MICROS));
    vehicle.wantReport();
  }

  /** A mission has at least one goal, so a cleared one has a place to hold at. */
  private void clear(int type, Sender from) {
    if (type != MISSION && type != MavMissionType.MAV_MISSION_TYPE_ALL.ordinal() && type != 255) {
      answers.refuseType(type, from);
      return;
    }
    Optional<StateInformation> here =
        vehicle.state().filter(state -> state.x().isPresent() && state.y().isPresent());
    if (here.isEmpty()) {
      refuse("mission not cleared: no position to hold at", type, from);
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
            refuse("mission not cleared: " + text, type, from);
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

  /** Asks again for what did not arrive, and acknowledges what was carried out. */
  public void step(long micros) {
    nowMicros = micros;
    upload.step(micros);
    confirmation
        .filter(each -> micros > each.deadlineMicros() || isReported(each.origin()))
        .ifPresent(
            each -> {
              confirmation = Optional.empty();
              answers.acknowledge(MavMissionResult.MAV_MISSION_ACCEPTED, each.type(), each.to());
            });
  }

  private boolean isReported(String origin) {
    return vehicle.report().filter(report -> report.mission().equals(origin)).isPresent();
  }
}
