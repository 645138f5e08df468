package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.List;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;

/** The fence as items, which the Safety Manager accepts or refuses. */
final class FenceItems implements ItemStore {
  private final VehicleOrders orders;
  private final FenceBook book;
  private final MissionAnswers answers;

  FenceItems(VehicleOrders orders, FenceBook book, MissionAnswers answers) {
    this.orders = orders;
    this.book = book;
    this.answers = answers;
  }

  @Override
  public List<MissionItem> listed() {
    FenceBook.Listed listed = book.listed();
    listed.lost().forEach(each -> answers.warn(each + " is not shown"));
    return listed.items();
  }

  @Override
  public void replace(List<MissionItem> items, Sender from) {
    FenceBook.Upload upload;
    try {
      upload = book.read(items);
    } catch (PlanRefusal e) {
      answers.refuse(e.result(), e.getMessage(), MissionAnswers.FENCE, from);
      return;
    }
    orders.fence(
        new FenceOrder().action(FenceAction.REPLACE).file(upload.name()).fence(upload.xml()),
        (accepted, text) -> {
          if (accepted) {
            book.accepted(upload);
            acknowledge(MissionAnswers.FENCE, from);
          } else {
            refuse("fence refused: " + text, MissionAnswers.FENCE, from);
          }
        });
  }

  @Override
  public void clear(int type, Sender from) {
    clear(() -> acknowledge(type, from), type, from);
  }

  /** Removes the fence, and acknowledges only if that was refused. */
  void clear(Runnable then, int type, Sender from) {
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

  private void acknowledge(int type, Sender to) {
    answers.acknowledge(MavMissionResult.MAV_MISSION_ACCEPTED, type, to);
  }

  private void refuse(String why, int type, Sender to) {
    answers.refuse(MavMissionResult.MAV_MISSION_ERROR, why, type, to);
  }
}
