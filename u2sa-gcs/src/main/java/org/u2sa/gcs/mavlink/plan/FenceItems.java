package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.List;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;

/** Areas or rally points of the fence as items, which the Safety Manager accepts or refuses. */
final class FenceItems implements ItemStore {
  private final int type;
  private final String what;
  private final VehicleOrders orders;
  private final FenceBook book;
  private final MissionAnswers answers;

  /**
   * @param type MAV_MISSION_TYPE
   * @param what name of the items in texts
   */
  FenceItems(int type, String what, VehicleOrders orders, FenceBook book, MissionAnswers answers) {
    this.type = type;
    this.what = what;
    this.orders = orders;
    this.book = book;
    this.answers = answers;
  }

  @Override
  public List<MissionItem> listed() {
    FenceBook.Listed listed = book.listed(type);
    listed.lost().forEach(each -> answers.warn(each + " is not shown"));
    return listed.items();
  }

  @Override
  public void replace(List<MissionItem> items, Sender from) {
    FenceBook.Upload upload;
    try {
      upload = book.read(type, items);
    } catch (PlanRefusal e) {
      answers.refuse(e.result(), e.getMessage(), type, from);
      return;
    }
    FenceOrder order =
        upload.xml().isEmpty()
            ? new FenceOrder().action(FenceAction.REMOVE)
            : new FenceOrder().action(FenceAction.REPLACE).file(upload.name()).fence(upload.xml());
    orders.fence(
        order,
        (accepted, text) -> {
          if (accepted) {
            book.accepted(upload);
            answers.acknowledge(MavMissionResult.MAV_MISSION_ACCEPTED, type, from);
          } else {
            refuse(what + " refused: " + text, type, from);
          }
        });
  }

  @Override
  public void clear(int type, Sender from) {
    replace(List.of(), from);
  }

  /** Removes the whole fence; acknowledges only a refusal. */
  void removeAll(Runnable then, int type, Sender from) {
    orders.fence(
        new FenceOrder().action(FenceAction.REMOVE),
        (accepted, text) -> {
          if (accepted) {
            then.run();
          } else {
            refuse("fence not removed: " + text, type, from);
          }
        });
  }

  private void refuse(String why, int type, Sender to) {
    answers.refuse(MavMissionResult.MAV_MISSION_ERROR, why, type, to);
  }
}
