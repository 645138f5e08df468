package org.u2sa.gcs.mavlink.event;

import io.dronefleet.mavlink.common.Event;
import io.dronefleet.mavlink.common.MavEventErrorReason;
import io.dronefleet.mavlink.common.RequestEvent;
import io.dronefleet.mavlink.common.ResponseEventError;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/** Sends events to one station, and repeats missed ones (mavlink.io/en/services/events). */
@SuppressWarnings("deprecation") // the library predates the final form of these messages
public final class EventTransfer {
  private static final int SEQUENCES = 0x1_0000;
  private static final int MAX_ANSWERS = 64;

  private final EventLog log;
  private final GroundStation station;
  private long sent; // of the vehicle's events

  public EventTransfer(VehicleEvents events, GroundStation station) {
    log = events.log();
    this.station = station;
    sent = log.count(); // earlier events are not sent
  }

  /** Sends new events. */
  public void step() {
    while (sent < log.count()) {
      sent++;
      log.get((int) (sent % SEQUENCES)).ifPresent(station::send);
    }
  }

  /** Sends events again; false if the message does not request that. */
  public boolean handle(Object message, Sender from) {
    if (!(message instanceof RequestEvent request)) {
      return false;
    }
    int count = Math.floorMod(request.lastSequence() - request.firstSequence(), SEQUENCES) + 1;
    for (int i = 0; i < Math.min(count, MAX_ANSWERS); i++) {
      int sequence = (request.firstSequence() + i) % SEQUENCES;
      Optional<Event> event = log.get(sequence);
      if (event.isEmpty()) {
        station.send(
            ResponseEventError.builder()
                .targetSystem(from.system())
                .targetComponent(from.component())
                .sequence(sequence)
                .sequenceOldestAvailable(log.oldest())
                .reason(MavEventErrorReason.MAV_EVENT_ERROR_REASON_UNAVAILABLE)
                .build());
        return true;
      }
      station.send(event.get());
    }
    return true;
  }
}
