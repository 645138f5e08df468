package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleMode;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;

/** The mission as items; an upload is acknowledged once it can be read back. */
final class MissionItems implements ItemStore {
  private static final int MISSION = MissionAnswers.MISSION;
  private static final long REPORT_MICROS = 1_000_000;

  /** A mission waiting for its acknowledgement. */
  private record Confirmation(String origin, int type, Sender to, long deadlineMicros) {}

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final PlanBook book;
  private final MissionAnswers answers;
  private Optional<Confirmation> confirmation = Optional.empty();
  private long nowMicros;

  MissionItems(VehicleStatus vehicle, VehicleOrders orders, PlanBook book, MissionAnswers answers) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.book = book;
    this.answers = answers;
  }

  @Override
  public List<MissionItem> listed() {
    return book.listed();
  }

  @Override
  public boolean isCurrent(int seq) {
    return vehicle.current().flatMap(book::index).filter(at -> at == seq).isPresent();
  }

  @Override
  public void replace(List<MissionItem> items, Sender from) {
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

  /** A mission needs at least one goal, so clearing sets one: hold the present position. */
  @Override
  public void clear(int type, Sender from) {
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

  /** Acknowledges an upload or clearing that was carried out. */
  void step(long micros) {
    nowMicros = micros;
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
